#include "core/score/kit_sticking.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/score/sticking_trace.hpp"

namespace percussionist::score {

namespace {

constexpr int kForgotten = -1;
constexpr int kMostHitsBack = 30;
constexpr double kLeftOut = 1000.0;
constexpr double kLoudness = 500.0;
constexpr double kHopeless = 2 * (kLeftOut + kLoudness) + 500.0;

struct State {
    std::array<int, 2> last{kForgotten, kForgotten};  ///< hit of the left and of the right hand
    std::array<bool, 2> bounced{false, false};
    double cost = 0.0;
};

/// Finds the state with the same pasts in the layer that is being made.
class StateIndex {
  public:
    void begin_layer(int newest) {
        ++layer_;
        newest_ = newest;
    }
    /// Where the state is in the layer, or `fresh`, which it then has.
    std::uint32_t place(const State& state, std::uint32_t fresh) {
        std::size_t key = 0;
        for (int h = 0; h < 2; ++h) {
            const int back = state.last[h] == kForgotten ? 0 : newest_ - state.last[h] + 1;
            key = (key * kBacks + back) * 2 + (state.bounced[h] ? 1 : 0);
        }
        Entry& entry = entries_[key];
        if (entry.layer != layer_) entry = {layer_, fresh};
        return entry.place;
    }

  private:
    static constexpr std::size_t kBacks = kMostHitsBack + 2;
    struct Entry {
        std::uint64_t layer = 0;
        std::uint32_t place = 0;
    };
    std::array<Entry, 4 * kBacks * kBacks> entries_{};
    std::uint64_t layer_ = 0;
    int newest_ = 0;
};

/// Efforts come of either hand's past by itself: each is asked for once, whatever the states.
class EffortTable {
  public:
    EffortTable(const Kit& kit, std::span<const HandHit> hits) : effort_(kit), hits_(hits) {}

    const Effort& alone(int hit, Limb hand, int last, bool bounced) {
        Entry& entry = alone_[index(hand)][bounced ? 1 : 0][back(hit, last)];
        if (entry.hit != hit) entry = {hit, effort_.alone(hits_[hit], hand, past(last, bounced))};
        return entry.effort;
    }
    const Effort& beside(int hit, Limb hand, int last) {
        Entry& entry = beside_[index(hand)][back(hit, last)];
        if (entry.hit != hit) entry = {hit, effort_.beside(hits_[hit], hand, past(last, false))};
        return entry.effort;
    }

  private:
    struct Entry {
        int hit = -1;
        Effort effort;
    };
    using Entries = std::array<Entry, kMostHitsBack + 3>;
    static std::size_t back(int hit, int last) { return last == kForgotten ? 0 : hit - last; }
    [[nodiscard]] HandPast past(int last, bool bounced) const {
        return last == kForgotten ? HandPast{} : HandPast{&hits_[last], bounced};
    }

    HandEffort effort_;
    std::span<const HandHit> hits_;
    std::array<std::array<Entries, 2>, 2> alone_;
    std::array<Entries, 2> beside_;
};

class Search {
  public:
    Search(const Kit& kit, std::span<const HandHit> hits)
        : efforts_(kit, hits), hits_(hits), states_(1) {}

    void advance(const HitGroup& group) {
        before_.swap(states_);
        states_.clear();
        layer_start_.push_back(steps_.size());
        newest_ = static_cast<int>(group.first + group.count) - 1;
        index_.begin_layer(newest_);
        for (std::uint32_t i = 0; i < before_.size(); ++i) {
            step_ = {i, {Played::not_at_all, Played::not_at_all}};
            play(before_[i], group, 0);
        }
        prune();
    }

    [[nodiscard]] std::vector<Played> trace(std::span<const HitGroup> groups) const {
        return trace_back(groups, hits_.size(), best(),
                          [this](std::size_t group, std::size_t state) -> const StickingStep& {
                              return steps_[layer_start_[group] + state];
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
        for (const Limb hand : {Limb::right_hand, Limb::left_hand}) {
            State next = state;
            if (!strike(next, hit, hand)) continue;
            step_.played[k] = hand == Limb::left_hand ? Played::left : Played::right;
            play(next, group, k + 1);
        }
        State without = state;
        without.cost += kLeftOut + kLoudness * hits_[hit].velocity;
        step_.played[k] = Played::not_at_all;
        play(without, group, k + 1);
    }

    bool strike(State& state, int hit, Limb hand) {
        const auto h = index(hand);
        const Effort& alone = efforts_.alone(hit, hand, state.last[h], state.bounced[h]);
        const Effort& beside = efforts_.beside(hit, hand, state.last[1 - h]);
        if (!alone.possible() || !beside.possible()) return false;
        state.cost += alone.total() + beside.total();
        state.last[h] = hit;
        state.bounced[h] = alone.bounces;
        return true;
    }

    /// Of all ways that leave the hands alike, the cheapest.
    void keep(State state) {
        forget(state);
        const std::uint32_t fresh = static_cast<std::uint32_t>(states_.size());
        const std::uint32_t place = index_.place(state, fresh);
        if (place == fresh) {
            states_.push_back(state);
            steps_.push_back(step_);
        } else if (state.cost < states_[place].cost) {
            states_[place] = state;
            steps_[layer_start_.back() + place] = step_;
        }
    }

    void forget(State& state) const {
        for (int h = 0; h < 2; ++h) {
            const int last = state.last[h];
            if (last == kForgotten) continue;
            if (newest_ - last > kMostHitsBack ||
                hits_[newest_].time - hits_[last].time > HandEffort::kMemory) {
                state.last[h] = kForgotten;
                state.bounced[h] = false;
            }
        }
    }

    void prune() {
        const double most = states_[best()].cost + kHopeless;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < states_.size(); ++i) {
            if (states_[i].cost > most) continue;
            states_[kept] = states_[i];
            steps_[layer_start_.back() + kept] = steps_[layer_start_.back() + i];
            ++kept;
        }
        states_.resize(kept);
        steps_.resize(layer_start_.back() + kept);
    }

    [[nodiscard]] std::size_t best() const {
        const auto least =
            std::min_element(states_.begin(), states_.end(),
                             [](const State& a, const State& b) { return a.cost < b.cost; });
        return static_cast<std::size_t>(least - states_.begin());
    }

    EffortTable efforts_;
    std::span<const HandHit> hits_;
    std::vector<State> states_;
    std::vector<State> before_;
    StateIndex index_;
    std::vector<StickingStep> steps_;       ///< layer after layer, one for each state
    std::vector<std::size_t> layer_start_;  ///< in steps_
    StickingStep step_;                     ///< the one being tried
    int newest_ = 0;                        ///< the last hit of the group being played
};

}  // namespace

std::vector<Played> assign_hands(const Kit& kit, std::span<const HandHit> hits,
                                 std::span<const HitGroup> groups) {
    Search search(kit, hits);
    for (const HitGroup& group : groups) search.advance(group);
    return search.trace(groups);
}

}  // namespace percussionist::score
