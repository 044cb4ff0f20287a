#include "core/motion/cycle_clock.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr double kEarlyGain = 0.5;
constexpr double kLateGain = 0.01;
constexpr double kPeriodGain = 0.01;   // of the correction
constexpr double kPeriodRange = 0.01;  // of the nominal
constexpr double kLongestGap = 2.0;    // [s]: beyond, the grid is not counted on
constexpr double kAstray = 0.3;        // of a period
constexpr int kMostAstray = 8;

}  // namespace

CycleClock::CycleClock(double period) : nominal_(period), period_(period) {}

double CycleClock::smooth(double arrival) noexcept {
    const double cycles = std::round((arrival - last_) / period_);
    const double error = arrival - last_ - cycles * period_;
    const bool fits = locked_ && cycles >= 0 && arrival - last_ < kLongestGap &&
                      std::abs(error) < kAstray * period_;
    if (!fits) {
        if (!locked_ || ++astray_ > kMostAstray || arrival - last_ >= kLongestGap) {
            locked_ = true;
            last_ = arrival;
            astray_ = 0;
        }
        return arrival;
    }
    astray_ = 0;
    const double correction = (error < 0.0 ? kEarlyGain : kLateGain) * error;
    last_ += cycles * period_ + correction;
    period_ = std::clamp(period_ + kPeriodGain * correction, nominal_ * (1 - kPeriodRange),
                         nominal_ * (1 + kPeriodRange));
    return last_;
}

}  // namespace percussionist::motion
