#include "core/score/song_clock.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::score {

namespace {

constexpr double kMemory = 1.0;   // [s]
constexpr double kJump = 0.08;    // [s]
constexpr double kFollow = 0.05;  // what is shown goes after the estimate [s]
constexpr double kSlew = 0.2;     // at most, of the rate
constexpr double kSlowest = 0.5, kFastest = 2.0;
constexpr double kSame = 1e-6;  // two places told of one instant [s]

}  // namespace

void SongClock::play(double now, double from) {
    tempo_.begin(now, from);
    course_ = Course::alone;
    shown_ = from;
    jumped_ = true;
}

void SongClock::jump(double now, double at, double position) {
    x_ = position;
    at_ = at;
    told_ = 1;
    shown_ = expected(now);
    jumped_ = true;
}

void SongClock::told(double now, double at, double position) {
    if (course_ != Course::led) {
        const double stood = shown_;
        rate_ = 1.0;
        course_ = Course::led;
        jump(now, at, position);
        // Where it goes on is nearly where it stood: no reason for a jump.
        if (std::abs(stood - shown_) < kJump) {
            shown_ = stood;
            jumped_ = false;
        }
        return;
    }
    const double error = position - expected(at);
    if (std::abs(error) > kJump) {
        jump(now, at, position);
        return;
    }
    const double dt = at - at_;
    ++told_;
    if (dt < kSame) {
        x_ += error / told_;
        return;
    }
    const double theta = std::exp(-dt / kMemory);
    x_ = expected(at) + std::max(1.0 - theta * theta, 1.0 / told_) * error;
    at_ = at;
    rate_ = std::clamp(rate_ + (1.0 - theta) * (1.0 - theta) * error / dt, kSlowest, kFastest);
}

void SongClock::hold(std::optional<double> position) {
    course_ = Course::still;
    if (!position || *position == shown_) return;
    shown_ = *position;
    jumped_ = true;
}

SongStep SongClock::advance(double now) {
    SongStep step{shown_, shown_, 0.0, jumped_};
    const double dt = now - now_;
    now_ = now;
    if (course_ == Course::alone) {
        shown_ = tempo_.position(now);
        step.rate = dt > 0.0 ? (shown_ - step.from) / dt : tempo_.factor(now);
        if (jumped_) step.rate = tempo_.factor(now);
    } else if (course_ == Course::led) {
        if (!jumped_) {
            const double way = rate_ * dt;
            const double gap = expected(now) - (shown_ + way);
            const double most = kSlew * way;
            shown_ += way + std::clamp(gap * (1.0 - std::exp(-dt / kFollow)), -most, most);
        }
        step.rate = rate_;
    }
    jumped_ = false;
    step.to = shown_;
    return step;
}

}  // namespace percussionist::score
