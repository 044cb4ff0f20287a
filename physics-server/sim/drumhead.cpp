#include "sim/drumhead.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::sim {

namespace {

/// A contact begins when the force rises above the first, and has paused when it is below the
/// second [N].
constexpr double kTouchForce = 0.5;
constexpr double kLeaveForce = 0.1;
/// It is over when it has paused for so long, or has lasted so long: then it is told [s].
constexpr double kPause = 0.0015;
constexpr double kLongest = 0.010;
/// What touches again within this of a stroke's beginning is a re-contact of it [s].
constexpr double kRest = 0.025;
/// The modes are evaluated anew for a tip that has moved so far [m].
constexpr double kSamePlace = 0.002;
/// A tip so far below the head that does not touch it came from there [m].
constexpr double kBelow = 0.006;
/// Below this energy the head is at rest [J].
constexpr double kStill = 1e-14;

int samples_in(double h, double rate) {
    return std::max(1, static_cast<int>(std::lround(h * rate)));
}

}  // namespace

Drumhead::Drumhead(const DrumheadOptions& options, double h)
    : Drumhead(modal::Resonator(options.membrane, options.decay, {.count = options.modes}),
               options.tip, options.fine_rate, h) {}

Drumhead::Drumhead(modal::Resonator body, const modal::Mallet& felt, double fine_rate, double h)
    : felt_(felt),
      samples_(samples_in(h, fine_rate)),
      period_(h / samples_),
      head_(std::move(body), 1.0 / period_) {
    modal::check(felt_);
    for (modal::Striker& striker : strikers_) striker = {felt_, 1.0, 0.0, 0.0, 0.0};
}

void Drumhead::tune(const modal::Membrane& membrane, const modal::Decay& decay) {
    head_.retune(membrane, decay);
    for (Hand& hand : hands_) hand.placed = linear::Vector3::Constant(1e9);
}

void Drumhead::set_tip_stiffness(double stiffness) {
    modal::Mallet felt = felt_;
    felt.stiffness = stiffness;
    modal::check(felt);
    felt_ = felt;
    for (modal::Striker& striker : strikers_) striker.mallet.stiffness = stiffness;
}

bool Drumhead::near(const TouchingTip& tip) const {
    constexpr double kMargin = 0.003;
    const double reach = std::max(0.0, -tip.velocity.z()) * period_ * samples_;
    const double radius = head_.resonator().radius();
    return tip.place.head<2>().norm() < radius && tip.place.z() < kMargin + 1.5 * reach &&
           tip.place.z() > -kBelow;
}

void Drumhead::take_up(std::size_t hand, const TouchingTip& tip) {
    Hand& h = hands_[hand];
    modal::Striker& striker = strikers_[hand];
    if ((tip.place - h.placed).head<2>().norm() > kSamePlace) {
        const double x = tip.place.x();
        const double y = tip.place.y();
        head_.place(hand, std::hypot(x, y), std::atan2(y, x));
        h.placed = tip.place;
    }
    striker.mallet.mass = tip.mass;
    striker.acceleration = tip.acceleration;
    striker.velocity = tip.velocity.z();
    if (h.phase == Phase::away) striker.position = tip.place.z();
}

std::array<double, 2> Drumhead::step(double time, const std::array<TouchingTip, 2>& tips,
                                     std::vector<ContactEvent>& contacts) {
    impulses_ = {};
    bool any = false;
    for (std::size_t i = 0; i < tips.size(); ++i) {
        if (near(tips[i]) || hands_[i].phase != Phase::away) {
            take_up(i, tips[i]);
            any = true;
        } else {
            strikers_[i].position = 1.0;  // out of reach
            strikers_[i].velocity = strikers_[i].acceleration = 0.0;
        }
    }
    if (any || !at_rest_) {
        for (int s = 0; s < samples_; ++s) {
            std::array<Approach, 2> before;
            for (std::size_t i = 0; i < tips.size(); ++i) {
                before[i] = {strikers_[i].position - head_.displacement(i), strikers_[i].velocity};
            }
            head_.step(strikers_);
            for (std::size_t i = 0; i < tips.size(); ++i) {
                sample(time + s * period_, i, tips[i], before[i]);
            }
        }
        at_rest_ = !any && head_.bank().energy() < kStill;
        if (at_rest_) head_.rest();
    }
    const double end = time + samples_ * period_;
    for (Hand& hand : hands_) end_if_over(hand, end, contacts);
    return impulses_;
}

void Drumhead::sample(double time, std::size_t hand, const TouchingTip& tip,
                      const Approach& before) {
    const double force = strikers_[hand].force;
    impulses_[hand] += force * period_;
    Hand& h = hands_[hand];
    if (h.phase == Phase::away && force > kTouchForce) {
        // Where the felt met the head inside this sample, or before it if the force was slight.
        const double until = before.velocity < 0.0 ? before.height / -before.velocity : 0.0;
        begin(hand, tip, time + std::clamp(until, -20.0 * period_, period_));
        h.event.velocity.z() = before.velocity;
    }
    if (force > kLeaveForce) h.last_touch = time + period_;
    if (h.phase != Phase::touching) return;
    h.event.impulse += force * period_;
    h.event.peak_force.z() = std::min(h.event.peak_force.z(), -force);
}

void Drumhead::begin(std::size_t hand, const TouchingTip& tip, double instant) {
    Hand& h = hands_[hand];
    h.phase = Phase::touching;
    ContactEvent& event = h.event;
    event = {};
    event.hand = static_cast<body::Hand>(hand);
    event.instant = instant;
    event.place = {tip.place.x(), tip.place.y(), 0.0};
    event.velocity = tip.velocity;
    event.effective_mass = tip.bare_mass;
    event.recontact = instant - h.last_stroke < kRest;
    if (!event.recontact) h.last_stroke = instant;
}

void Drumhead::end_if_over(Hand& hand, double time, std::vector<ContactEvent>& contacts) const {
    const bool left = time - hand.last_touch > kPause;
    if (hand.phase == Phase::touching && (left || time - hand.event.instant > kLongest)) {
        hand.phase = Phase::told;
        hand.event.duration = hand.last_touch - hand.event.instant;
        contacts.push_back(hand.event);
    }
    if (hand.phase == Phase::told && left) hand.phase = Phase::away;
}

}  // namespace percussionist::sim
