// How a search for sticking remembers its ways and reads the best one back: what the searches for
// one drum and for a kit have in common.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/score/sticking.hpp"

namespace percussionist::score {

/// The way into a state: which of the states before the group it came from, and who plays the
/// group.
struct StickingStep {
    std::uint32_t from = 0;
    std::array<Played, 2> played{Played::not_at_all, Played::not_at_all};
};

/// Who plays each of `hits` hits, from the state `last` after the last group backwards;
/// step(group, state) is the way into a state.
template <class StepAt>
std::vector<Played> trace_back(std::span<const HitGroup> groups, std::size_t hits, std::size_t last,
                               const StepAt& step) {
    std::vector<Played> played(hits, Played::not_at_all);
    for (std::size_t g = groups.size(); g-- > 0;) {
        const StickingStep& way = step(g, last);
        for (std::size_t k = 0; k < groups[g].count; ++k) {
            played[groups[g].first + k] = way.played[k];
        }
        last = way.from;
    }
    return played;
}

}  // namespace percussionist::score
