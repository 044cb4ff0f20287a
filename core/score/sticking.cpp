#include "core/score/sticking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <unordered_map>

#include "core/score/sticking_trace.hpp"

namespace percussionist::score {

namespace {

/// What a hand did longer ago than this [s] no longer matters to it.
constexpr double kMemory = 0.8;
/// A hand that repeats after this long [s] is as awkward as one unit.
constexpr double kEasyRepeat = 0.25;
/// Awkwardness of the left hand on a bar's first beat, on another beat, and elsewhere.
constexpr double kLeftOnDownbeat = 0.3;
constexpr double kLeftOnBeat = 0.1;
constexpr double kLeftOffBeat = 0.04;
/// Among equally many hits left out, the quieter ones.
constexpr double kLoudnessLost = 5.0;

constexpr int kForgotten = -1;

struct Cost {
    int left_out = 0;
    double awkwardness = 0.0;
    auto operator<=>(const Cost&) const = default;
};

struct State {
    std::array<int, 2> last{kForgotten, kForgotten};  ///< hit of the left and of the right hand
    Cost cost;
};

class Search {
  public:
    Search(std::span<const Hit> hits, double min_interval)
        : hits_(hits), min_interval_(min_interval), states_(1) {}

    void advance(const HitGroup& group) {
        before_.swap(states_);
        states_.clear();
        index_.clear();
        steps_.emplace_back();
        now_ = hits_[group.first].time;
        for (std::uint32_t i = 0; i < before_.size(); ++i) {
            step_ = {i, {Played::not_at_all, Played::not_at_all}};
            play(before_[i], group, 0);
        }
        prune();
    }

    [[nodiscard]] std::vector<Played> trace(std::span<const HitGroup> groups) const {
        return trace_back(groups, hits_.size(), best(),
                          [this](std::size_t group, std::size_t state) -> const StickingStep& {
                              return steps_[group][state];
                          });
    }

  private:
    /// Tries every way to play the group's hits from the k-th on.
    void play(const State& state, const HitGroup& group, std::size_t k) {
        if (k == group.count) {
            keep(state);
            return;
        }
        const int hit = static_cast<int>(group.first + k);
        for (const Played way : {Played::right, Played::left, Played::not_at_all}) {
            State next = state;
            if (way == Played::not_at_all) {
                next.cost.left_out += 1;
                next.cost.awkwardness += kLoudnessLost * hits_[hit].velocity;
            } else if (!strike(next, hit, static_cast<int>(way))) {
                continue;
            }
            step_.played[k] = way;
            play(next, group, k + 1);
        }
    }

    /// False if the hand cannot be there.
    bool strike(State& state, int hit, int hand) const {
        int& last = state.last[hand];
        if (last != kForgotten) {
            const double gap = hits_[hit].time - hits_[last].time;
            if (gap < min_interval_) {
                return false;
            }
            const double repeat = kEasyRepeat / std::min(gap, kMemory);
            const double no_repeat = kEasyRepeat / kMemory;
            state.cost.awkwardness += repeat * repeat - no_repeat * no_repeat;
        }
        if (hand == static_cast<int>(Played::left)) {
            state.cost.awkwardness += of_left_hand(hits_[hit].beat);
        }
        last = hit;
        return true;
    }

    static double of_left_hand(double beat) {
        constexpr double kOnBeat = 0.05;
        if (std::abs(beat - std::round(beat)) > kOnBeat) {
            return kLeftOffBeat;
        }
        return std::round(beat) == 1.0 ? kLeftOnDownbeat : kLeftOnBeat;
    }

    /// Of all ways that leave the hands alike, the cheapest.
    void keep(State state) {
        forget(state);
        const std::uint64_t key = (static_cast<std::uint64_t>(state.last[0] + 1) << 32U) |
                                  static_cast<std::uint64_t>(state.last[1] + 1);
        const auto [entry, is_new] = index_.try_emplace(key, states_.size());
        if (is_new) {
            states_.push_back(state);
            steps_.back().push_back(step_);
        } else if (state.cost < states_[entry->second].cost) {
            states_[entry->second] = state;
            steps_.back()[entry->second] = step_;
        }
    }

    void forget(State& state) const {
        const double memory = std::max(kMemory, min_interval_);
        for (int& last : state.last) {
            if (last != kForgotten && now_ - hits_[last].time > memory) {
                last = kForgotten;
            }
        }
    }

    /// The best state can do whatever another does from here on, except for at most one stroke of
    /// each hand that comes too soon for it. Who is three behind cannot catch up.
    void prune() {
        const int least = states_[best()].cost.left_out;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            if (states_[i].cost.left_out <= least + 2) {
                states_[kept] = states_[i];
                steps_.back()[kept] = steps_.back()[i];
                ++kept;
            }
        }
        states_.resize(kept);
        steps_.back().resize(kept);
        steps_.back().shrink_to_fit();
    }

    [[nodiscard]] std::uint32_t best() const {
        const auto least =
            std::min_element(states_.begin(), states_.end(),
                             [](const State& a, const State& b) { return a.cost < b.cost; });
        return static_cast<std::uint32_t>(least - states_.begin());
    }

    std::span<const Hit> hits_;
    double min_interval_;
    std::vector<State> states_;
    std::vector<State> before_;
    std::unordered_map<std::uint64_t, std::size_t> index_;
    std::vector<std::vector<StickingStep>> steps_;  ///< of each group, one for each state after it
    StickingStep step_;                             ///< the one being tried
    double now_ = 0.0;                              ///< time of the group being played [s]
};

}  // namespace

std::vector<Played> assign_hands(std::span<const Hit> hits, std::span<const HitGroup> groups,
                                 double min_interval) {
    Search search(hits, min_interval);
    for (const HitGroup& group : groups) {
        search.advance(group);
    }
    return search.trace(groups);
}

}  // namespace percussionist::score
