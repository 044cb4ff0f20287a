#include "body/stroke_path.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::body {

namespace {

/// A quintic that comes to rest from speed v (or starts from rest) within T covers v T / 2 if its
/// speed is not to overshoot; played strokes peak at 1.2 to 1.4 times their speed at the impact
/// (docs/body.md), which this share of v T gives.
constexpr double kShare = 1.0 / 1.7;
/// Below this time between strokes the tip swings from one to the next in a single arc [s].
constexpr double kSingleArc = 0.30;
/// A rebound comes to rest within this time, or at this height if it would rise higher [s], [m].
constexpr double kReboundTime = 0.25;
constexpr double kHighestRebound = 0.42;
/// From the top of a rebound to the waiting height, and from there to the raised stick [s].
constexpr double kSinkTime = 0.40;
constexpr double kRaiseTime = 0.35;
/// In a rise shorter than this the hand need not catch up with the tip [s].
constexpr double kShortRise = 0.1;
/// How much of the tip's speed the hand has when it strikes.
constexpr double kHandSpeedShare = 0.10;
constexpr double kForever = 1e9;
/// Of a gesture: most of the rise lies in this time before the stroke [s]; no rise is faster than
/// this on average, if there is time, and at its fastest [m/s]; between strokes the tip is lowered
/// to this height [m].
constexpr double kRiseWindow = 0.40;
constexpr double kRiseSpeed = 2.0;
constexpr double kFastestRise = 5.0;
constexpr double kLowered = 0.03;

/// The time in which to go from one state to the other so that the largest speed on the way is
/// `peak`: the shorter, the faster.
double time_with_peak(const PathState& a, const PathState& b, double peak) {
    const auto fastest = [&](double time) {
        const Quintic path(0.0, a, time, b);
        constexpr int kParts = 64;
        double most = 0.0;
        for (int i = 0; i <= kParts; ++i) {
            most = std::max(most, std::abs(path.at(time * i / kParts).velocity));
        }
        return most;
    };
    double shortest = 0.02;
    double longest = 1.0;
    for (int halving = 0; halving < 40; ++halving) {
        const double middle = 0.5 * (shortest + longest);
        (fastest(middle) > peak ? shortest : longest) = middle;
    }
    return longest;
}

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

double Quintic::top() const {
    constexpr int kParts = 24;
    const double step = (end_ - start_) / kParts;
    for (int i = 0; i < kParts; ++i) {
        double low = start_ + i * step;
        double high = low + step;
        if (!(at(low).velocity > 0.0 && at(high).velocity <= 0.0)) continue;
        for (int halving = 0; halving < 30; ++halving) {
            const double middle = 0.5 * (low + high);
            (at(middle).velocity > 0.0 ? low : high) = middle;
        }
        return low;
    }
    return end_;
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

PathState StrokePath::tip(double t) const {
    return tip_.at(t);
}
PathState StrokePath::hand(double t) const {
    return hand_.at(t);
}

double StrokePath::free_from(double now) const {
    if (next_.holds(now)) return next_.leaves;
    return last_.holds(now) ? last_.leaves : now;
}

StrokePath::Pen StrokePath::cut(double now) {
    const double start = free_from(now);
    const Pen pen{start, tip_.at(start), hand_.at(start)};
    const PathState tip_now = tip_.at(now);
    const PathState hand_now = hand_.at(now);
    tip_.restart();
    hand_.restart();
    // A dip under way stays: a quintic through two states of a quintic is that quintic.
    tip_.add(now, tip_now, start, pen.tip);
    hand_.add(now, hand_now, start, pen.hand);
    return pen;
}

void StrokePath::draw(Pen& pen, double t, const PathState& tip, const PathState& hand) {
    tip_.add(pen.time, pen.tip, t, tip);
    const Quintic flight(pen.time, pen.tip, t, tip);
    const double top = flight.top();
    const double height = flight.at(top).position;
    constexpr double kLowest = 0.01;  // of a top that is one [m]
    PathState between = pen.hand;
    double at = pen.time;
    if (top < t && top > at && height > std::max(pen.tip.position, tip.position) + kLowest) {
        // Where the tip flies over a top the hand goes with it.
        between = {kHandShare * height, 0.0, 0.0};
        at = top;
    } else if (pen.tip.velocity > 0.0 && t - at > kShortRise) {
        // Thrown up by the head the tip is fast at first; the hand catches up with it.
        at += (t - at) / 3.0;
        const PathState rising = flight.at(at);
        between = {kHandShare * rising.position, kHandShare * rising.velocity,
                   kHandShare * rising.acceleration};
    }
    hand_.add(pen.time, pen.hand, at, between);
    hand_.add(at, between, t, hand);
    pen = {t, tip, hand};
}

void StrokePath::draw_rest(Pen& pen, double t, double height) {
    draw(pen, t, {height, 0.0, 0.0}, {kHandShare * height, 0.0, 0.0});
}

StrokePath::Turn StrokePath::turn(const Pen& leaving, const std::optional<StrokeShape>& shape) {
    const double thrown = leaving.tip.velocity;
    if (thrown <= 0.0) return {leaving.time, leaving.tip.position};
    if (!shape) {
        const double time = std::min(kReboundTime, kHighestRebound / (kShare * thrown));
        return {leaving.time + time, leaving.tip.position + kShare * thrown * time};
    }
    // Thrown up faster than the gesture goes, the stick is slowed down to its height at once.
    const StrokeShape& s = *shape;
    const double time = thrown >= s.peak_up
                            ? s.rebound / (kShare * thrown)
                            : time_with_peak(leaving.tip, {s.rebound, 0.0, 0.0}, s.peak_up);
    return {leaving.time + time, s.rebound};
}

/// To where the rebound comes to rest, if that lies ahead.
void StrokePath::draw_turn(Pen& pen, const Turn& turn) {
    if (turn.time > pen.time) draw_rest(pen, turn.time, turn.height);
}

void StrokePath::wait(Pen& pen, const Turn& turn) {
    draw_turn(pen, turn);
    draw_rest(pen, pen.time + kSinkTime, kWaitingHeight);
    draw_rest(pen, pen.time + kForever, kWaitingHeight);
}

void StrokePath::rest(double now) {
    Pen pen = cut(now);
    if (aiming(now)) {
        next_ = {};
    } else {
        turn_ = turn(pen, aimed_);
    }
    aimed_.reset();
    wait(pen, turn_);
}

bool StrokePath::aim(double now, const Aim& wish) {
    if (wish.time - free_from(now) < kShortestAim) return false;
    Aim aim = wish;
    if (aim.shape) aim.speed = aim.shape->impact;
    Pen pen = cut(now);
    if (!aiming(now)) {
        last_ = next_;
        turn_ = turn(pen, aimed_);
    }
    if (aim.time - pen.time >= kSingleArc) raise(pen, aim);
    strike(pen, aim);
    next_ = {aim.time, aim.time + aim.rebound.duration};
    aimed_ = aim.shape;
    wait(pen, turn(pen, aimed_));
    return true;
}

bool StrokePath::can_be_followed(double now) const {
    constexpr double kHighest = 0.75;
    constexpr double kTouch = 1e-6;
    constexpr double kStrongest = 300.0;
    constexpr int kParts = 48;
    for (int i = 0; i <= kParts; ++i) {
        const double t = now + (next_.impact - now) * i / kParts;
        if (in_head(t)) continue;
        const PathState tip = tip_.at(t);
        if (tip.position < -kTouch || tip.position > kHighest) return false;
        if (std::abs(tip.acceleration) > kStrongest) return false;
    }
    return true;
}

StrokePath::Raise StrokePath::raise_for(const Aim& aim, const Pen& pen) {
    const double time = aim.time - pen.time;
    if (!aim.shape) {
        const double down = std::min(aim.height / (kShare * aim.speed), 0.5 * time);
        return {kShare * aim.speed * down, down, kRaiseTime, kWaitingHeight};
    }
    const StrokeShape& s = *aim.shape;
    const double whole = time_with_peak({s.rise, 0.0, 0.0}, {0.0, -s.impact, 0.0}, s.peak_down);
    const double down = std::min(whole, 0.5 * time);
    // A quintic from rest to rest is 1.875 times as fast at its middle as in the mean.
    const double highest = pen.tip.position + kFastestRise / 1.875 * (time - down);
    const double height = std::min(s.rise * down / whole, highest);
    // The rise takes what is left of 0.4 s before the stroke, or a little more for a high one.
    return {height, down, std::max(kRiseWindow - down, height / kRiseSpeed), kLowered};
}

void StrokePath::raise(Pen& pen, const Aim& aim) {
    const Raise raise = raise_for(aim, pen);
    const double raised = aim.time - raise.down;
    const double spare = raised - std::max(pen.time, turn_.time) - raise.time;
    if (spare > kSinkTime) {
        draw_turn(pen, turn_);
        draw_rest(pen, pen.time + kSinkTime, raise.from);
        draw_rest(pen, raised - raise.time, raise.from);
    } else if (spare > 0.0 && turn_.time > pen.time) {
        // No stop on the way from the rebound to the raised stick.
        const double v = (raise.height - turn_.height) / (raised - turn_.time);
        draw(pen, turn_.time, {turn_.height, v, 0.0},
             {kHandShare * turn_.height, kHandShare * v, 0.0});
    }
    draw_rest(pen, raised, raise.height);
}

void StrokePath::strike(Pen& pen, const Aim& aim) {
    const double hand_speed = kHandSpeedShare * aim.speed;
    draw(pen, aim.time, {0.0, -aim.speed, 0.0}, {0.0, -hand_speed, 0.0});
    draw(pen, aim.time + aim.rebound.duration, {0.0, aim.rebound.speed, 0.0},
         {-hand_speed * aim.rebound.duration, -hand_speed, 0.0});
}

}  // namespace percussionist::body
