#include "core/score/kit_feet.hpp"

#include <cstddef>

namespace percussionist::score {

namespace {

constexpr double kEach = 1000.0;  // a hit weighs this much plus its loudness, below 1

}  // namespace

std::vector<bool> thin(std::span<const FootHit> hits, double interval) {
    // worth[n]: the most that the first n hits can give; before[i]: how many end early enough for i
    std::vector<double> worth(hits.size() + 1, 0.0);
    std::vector<std::size_t> before(hits.size(), 0);
    std::size_t early = 0;
    const auto with = [&](std::size_t i) { return worth[before[i]] + kEach + hits[i].velocity; };
    for (std::size_t i = 0; i < hits.size(); ++i) {
        while (early < i && hits[i].time - hits[early].time >= interval) ++early;
        before[i] = early;
        worth[i + 1] = with(i) > worth[i] ? with(i) : worth[i];
    }
    std::vector<bool> played(hits.size(), false);
    for (std::size_t n = hits.size(); n > 0;) {
        if (with(n - 1) > worth[n - 1]) {
            played[n - 1] = true;
            n = before[n - 1];
        } else {
            --n;
        }
    }
    return played;
}

}  // namespace percussionist::score
