#include "core/score/kit_effort.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::score {

namespace {

constexpr double kEasySpeed = 6.0;    // [m/s]
constexpr double kDearRepeat = 0.16;  // [s]
constexpr double kBounce = 5.0;
constexpr double kPair = 3.0;
constexpr double kPairFades = 0.2;  // [s]
constexpr double kPairAtOnce = 5.0;
constexpr double kPreference = 1.4;
/// So far may the left stick be to the right of the right one before that is a crossing [m].
constexpr double kBesides = 0.03;

/// Of the left hand, on a bar's first beat, on another beat, and elsewhere.
double lead_of_left(double beat) {
    constexpr double kOnBeat = 0.05;
    if (std::abs(beat - std::round(beat)) > kOnBeat) return 0.04;
    return std::round(beat) == 1.0 ? 0.3 : 0.1;
}

}  // namespace

HandEffort::HandEffort(const Kit& kit)
    : kit_(kit), size_(kit.events.size()), crossed_(size_ * size_, false) {
    for (const Limb hand : {Limb::left_hand, Limb::right_hand}) {
        for (std::size_t e = 0; e < size_; ++e) {
            spots_[index(hand)].push_back(spot_of(kit, e, hand));
        }
    }
    for (std::size_t l = 0; l < size_; ++l) {
        for (std::size_t r = 0; r < size_; ++r) {
            const auto& pair = kit.pair(l, r);
            const bool asked = pair && pair->may_cross && pair->hand == Limb::left_hand;
            crossed_[l * size_ + r] = !asked && spots_[0][l].y() < spots_[1][r].y() - kBesides;
        }
    }
}

Effort HandEffort::of(const HandHit& hit, Limb hand, const HandPast& own,
                      const HandPast& other) const {
    Effort effort = alone(hit, hand, own);
    const Effort both = beside(hit, hand, other);
    if (effort.possible()) effort.obstacle = both.obstacle;
    effort.pair = both.pair;
    effort.preference = both.preference;
    return effort;
}

Effort HandEffort::alone(const HandHit& hit, Limb hand, const HandPast& own) const {
    Effort effort;
    if (!kit_.events[hit.event].reach[index(hand)]) effort.obstacle = Obstacle::reach;
    if (hand == Limb::left_hand) effort.lead = lead_of_left(hit.beat);
    if (own.hit != nullptr && effort.possible()) move(hit, hand, own, effort);
    return effort;
}

void HandEffort::move(const HandHit& hit, Limb hand, const HandPast& own, Effort& effort) const {
    const double gap = hit.time - own.hit->time;
    const bool same_object = kit_.events[hit.event].object == kit_.events[own.hit->event].object;
    if (gap < kit_.limits.interval) {
        effort.bounces = same_object && !own.bounced && gap >= kit_.limits.bounce;
        if (!effort.bounces) effort.obstacle = Obstacle::too_soon;
        effort.repeat = kBounce;
        return;
    }
    const double ratio = kDearRepeat / std::min(gap, kMemory);
    effort.repeat = ratio * ratio * ratio;
    const double speed = distance(hand, own.hit->event, hit.event) / (gap - kit_.limits.settling);
    if (speed > kit_.limits.speed) effort.obstacle = Obstacle::too_far;
    effort.way = speed * speed / (kEasySpeed * kEasySpeed);
}

Effort HandEffort::beside(const HandHit& hit, Limb hand, const HandPast& other) const {
    Effort effort;
    const KitEvent& event = kit_.events[hit.event];
    double pair_rules = 0.0;
    if (other.hit != nullptr) {
        const double since = hit.time - other.hit->time;
        const bool is_left = hand == Limb::left_hand;
        const std::size_t left = is_left ? hit.event : other.hit->event;
        const std::size_t right = is_left ? other.hit->event : hit.event;
        if (since <= kCrossingWithin && crossed(left, right)) effort.obstacle = Obstacle::crossing;
        if (const auto& pair = kit_.pair(hit.event, other.hit->event)) {
            pair_rules = std::exp(-since / kPairFades);
            const double weight = since <= kAtOnce ? kPairAtOnce * kPair : kPair;
            if (pair->hand != hand) effort.pair = weight * pair_rules;
        }
    }
    if (event.hand && *event.hand != hand) effort.preference = kPreference * (1.0 - pair_rules);
    return effort;
}

}  // namespace percussionist::score
