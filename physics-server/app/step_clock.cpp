#include "app/step_clock.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace percussionist::app {

namespace {

/// Behind by more than this, time pauses rather than rushes [s].
constexpr double kGiveUp = 0.5;

}  // namespace

StepClock::StepClock(WallClock& clock, double length)
    : clock_(clock), length_(length), start_(clock.now()) {}

void StepClock::begin() {
    start_ = clock_.now();
    done_ = 0;
}

void StepClock::pause_if_far_behind(double now) {
    const double behind = now - next_end();
    if (behind <= kGiveUp) return;
    start_ += behind;
    late_ += static_cast<int>(behind / length_);
    fmt::print(stderr, "held up for {:.2f} s: simulated time paused\n", behind);
}

double StepClock::take_busy() {
    return std::exchange(busy_, 0.0);
}

}  // namespace percussionist::app
