#include "core/timing/steady_line.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::timing {

namespace {

constexpr double kSure = 6.0;          // times a rate's error
constexpr double kSureFor = 2.0;       // [s]
constexpr double kTolerance = 8.0;     // times the tracker's uncertainty
constexpr double kSettling = 0.5;      // [s]
constexpr double kMoreSettling = 1.5;  // where the tracker is too uncertain [s]
constexpr double kBeyond = 1.5;        // times the tolerance; what lies beyond is followed at once
constexpr double kRested = 0.25;       // of the tolerance
constexpr double kPull = 1.5;          // within which an error is drawn in [s]

}  // namespace

void SteadyLine::follow(const ClockTracker& tracker, double x) noexcept {
    const double error = tracker.to_y(x) - to_y(x);
    if (!started_ || tracker.steps() != steps_ ||
        !(std::abs(error) <= std::max(settings_.jump, kBeyond * tolerance_))) {
        settling_until_ = x + kSettling;
    }
    if (x < settling_until_ || (x < settling_until_ + kMoreSettling &&
                                kTolerance * tracker.uncertainty() > settings_.most_tolerance)) {
        take(tracker, x);
        return;
    }
    compare(tracker, x);
    if (alike_) {
        hold(tracker, x, error);
    } else {
        bend(x, tracker.rate() + std::clamp(error / kPull, -settings_.slew, settings_.slew));
    }
}

void SteadyLine::take(const ClockTracker& tracker, double x) noexcept {
    started_ = true;
    steps_ = tracker.steps();
    x0_ = x;
    y0_ = tracker.to_y(x);
    rate_ = alike_ ? 0.0 : tracker.rate();
    tolerance_ = settings_.least_tolerance;
    rest(tracker);
}

void SteadyLine::compare(const ClockTracker& tracker, double x) noexcept {
    const bool apart = std::abs(tracker.rate()) > kSure * tracker.rate_error();
    if (!apart || !doubting_) {
        doubted_ = x;
    }
    doubting_ = apart;
    if (alike_ && x - doubted_ > kSureFor) {
        alike_ = false;
        take(tracker, x);
    }
}

void SteadyLine::hold(const ClockTracker& tracker, double x, double error) noexcept {
    const bool resting = rate_ == 0.0;
    if (resting && std::abs(error) > tolerance_) {
        bend(x, std::copysign(settings_.slew, error));
    } else if (!resting && error * rate_ <= kRested * tolerance_ * std::abs(rate_)) {
        bend(x, 0.0);
        rest(tracker);
    }
}

void SteadyLine::rest(const ClockTracker& tracker) noexcept {
    tolerance_ =
        std::clamp(kTolerance * tracker.uncertainty(), tolerance_, settings_.most_tolerance);
}

/// From x on.
void SteadyLine::bend(double x, double rate) noexcept {
    y0_ = to_y(x);
    x0_ = x;
    rate_ = rate;
}

}  // namespace percussionist::timing
