#include "body/stroke_path.hpp"

#include <algorithm>

namespace percussionist::body {

namespace {

/// A quintic that comes to rest from speed v (or starts from rest) within T covers v T / 2 if its
/// speed is not to overshoot; played strokes peak at 1.2 to 1.4 times their speed at the impact
/// (docs/physics.md), which this share of v T gives.
constexpr double kShare = 1.0 / 1.7;
/// Below this time between strokes the tip swings from one to the next in a single arc [s].
constexpr double kSingleArc = 0.35;
/// Time for a rebound to come to rest, and for a raise to begin from the waiting height [s].
constexpr double kReboundTime = 0.25;
constexpr double kRaiseTime = 0.35;
/// How much of the tip's movement the hand makes.
constexpr double kHandShare = 0.45;
constexpr double kHandSpeedShare = 0.10;
constexpr double kForever = 1e9;

}  // namespace

Quintic::Quintic(double t0, const PathState& a, double t1, const PathState& b)
    : start_(t0), end_(t1) {
    const double T = t1 - t0;
    const double T2 = T * T;
    const double dx = b.position - a.position - a.velocity * T - 0.5 * a.acceleration * T2;
    const double dv = (b.velocity - a.velocity - a.acceleration * T) * T;
    const double da = (b.acceleration - a.acceleration) * T2;
    c_[0] = a.position;
    c_[1] = a.velocity;
    c_[2] = 0.5 * a.acceleration;
    c_[3] = (10.0 * dx - 4.0 * dv + 0.5 * da) / (T2 * T);
    c_[4] = (-15.0 * dx + 7.0 * dv - da) / (T2 * T2);
    c_[5] = (6.0 * dx - 3.0 * dv + 0.5 * da) / (T2 * T2 * T);
}

PathState Quintic::at(double t) const {
    const double u = t - start_;
    PathState s;
    s.position = c_[0] + u * (c_[1] + u * (c_[2] + u * (c_[3] + u * (c_[4] + u * c_[5]))));
    s.velocity = c_[1] + u * (2 * c_[2] + u * (3 * c_[3] + u * (4 * c_[4] + u * 5 * c_[5])));
    s.acceleration = 2 * c_[2] + u * (6 * c_[3] + u * (12 * c_[4] + u * 20 * c_[5]));
    return s;
}

void StrokePath::Track::add(double t0, const PathState& a, double t1, const PathState& b) {
    if (t1 - t0 < 1e-9 || count_ == static_cast<int>(pieces_.size())) return;
    pieces_[count_++] = Quintic(t0, a, t1, b);
}

PathState StrokePath::Track::at(double t) const {
    int i = 0;
    while (i + 1 < count_ && t >= pieces_[i].end()) ++i;
    return pieces_[i].at(t);
}

StrokePath::StrokePath(double now) {
    const PathState waiting{kWaitingHeight, 0.0, 0.0};
    tip_.add(now, waiting, now + kForever, waiting);
    const PathState hand{kHandShare * kWaitingHeight, 0.0, 0.0};
    hand_.add(now, hand, now + kForever, hand);
}

PathState StrokePath::tip(double t) const { return tip_.at(t); }
PathState StrokePath::hand(double t) const { return hand_.at(t); }

void StrokePath::wait_from(Track& track, double t, const PathState& state, double height) {
    const PathState waiting{height, 0.0, 0.0};
    track.add(t, state, t + 2 * kReboundTime, waiting);
    track.add(t + 2 * kReboundTime, waiting, t + kForever, waiting);
}

double StrokePath::free_from(double now) const {
    if (next_.holds(now)) return next_.leaves;
    return last_.holds(now) ? last_.leaves : now;
}

StrokePath::Cut StrokePath::cut(double now) {
    const double start = free_from(now);
    const Cut cut{start, tip_.at(start), hand_.at(start)};
    const PathState tip_now = tip_.at(now);
    const PathState hand_now = hand_.at(now);
    tip_.restart();
    hand_.restart();
    // A dip under way stays: a quintic through two states of a quintic is that quintic.
    tip_.add(now, tip_now, start, cut.tip);
    hand_.add(now, hand_now, start, cut.hand);
    return cut;
}

void StrokePath::rest(double now) {
    const Cut from = cut(now);
    if (aiming(now)) next_ = {};
    wait_from(tip_, from.time, from.tip, kWaitingHeight);
    wait_from(hand_, from.time, from.hand, kHandShare * kWaitingHeight);
}

bool StrokePath::aim(double now, const Aim& aim) {
    if (aim.time - free_from(now) < kShortestAim) return false;
    const Cut from = cut(now);
    raise_and_strike(from, aim);
    if (!aiming(now)) last_ = next_;
    next_ = {aim.time, aim.time + aim.rebound.duration};
    return true;
}

void StrokePath::raise_and_strike(const Cut& from, const Aim& aim) {
    const double hand_speed = kHandSpeedShare * aim.speed;
    const PathState impact{0.0, -aim.speed, 0.0};
    const PathState hand_impact{0.0, -hand_speed, 0.0};
    const double time = aim.time - from.time;
    double at = from.time;
    PathState tip = from.tip;
    PathState hand = from.hand;
    const auto to = [&](double t, const PathState& next_tip, const PathState& next_hand) {
        tip_.add(at, tip, t, next_tip);
        hand_.add(at, hand, t, next_hand);
        at = t;
        tip = next_tip;
        hand = next_hand;
    };
    if (time >= kSingleArc) {
        const double down = std::min(aim.height / (kShare * aim.speed), 0.5 * time);
        const double height = kShare * aim.speed * down;
        const double raised = aim.time - down;
        if (raised - at > kReboundTime + kRaiseTime) {
            const double waiting =
                std::max(kWaitingHeight, kShare * tip.velocity * kReboundTime);
            const PathState wait_tip{waiting, 0.0, 0.0};
            const PathState wait_hand{kHandShare * waiting, 0.0, 0.0};
            to(at + kReboundTime, wait_tip, wait_hand);
            to(raised - kRaiseTime, wait_tip, wait_hand);
        }
        to(raised, {height, 0.0, 0.0}, {kHandShare * height, 0.0, 0.0});
    }
    to(aim.time, impact, hand_impact);
    const double leaves = aim.time + aim.rebound.duration;
    to(leaves, {0.0, aim.rebound.speed, 0.0},
       {-hand_speed * aim.rebound.duration, -hand_speed, 0.0});
    wait_from(tip_, at, tip, kWaitingHeight);
    wait_from(hand_, at, hand, kHandShare * kWaitingHeight);
}

}  // namespace percussionist::body
