// From the system's steady clock to Pd's logical time.
//
// Logical time stands still between ticks and then jumps; a tick may come late, never early. So the
// two clocks are compared at each tick and the earliest tick of the last quarter second counts; the
// map then follows slowly, for the clocks drift by some 10 ppm. A step of more than a quarter
// second (a drop-out, a pause) is followed at once. Pd's thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace percussionist::io {

class ClockMap {
  public:
    /// Both read now [s].
    void observe(double steady, double logical) noexcept {
        const double offset = steady - logical;
        if (!known_ || std::abs(offset - offset_) > kStep) {
            known_ = true;
            offset_ = least_ = offset;
            window_end_ = steady + kWindow;
            return;
        }
        offset_ = std::min(offset_, offset);
        least_ = std::min(least_, offset);
        if (steady >= window_end_) {
            offset_ += kGain * (least_ - offset_);
            least_ = std::numeric_limits<double>::infinity();
            window_end_ = steady + kWindow;
        }
    }

    double logical(double steady) const noexcept { return steady - offset_; }
    bool known() const noexcept { return known_; }

  private:
    static constexpr double kStep = 0.25;    // [s]
    static constexpr double kWindow = 0.25;  // [s]
    static constexpr double kGain = 0.1;
    double offset_ = 0.0;
    double least_ = 0.0;
    double window_end_ = 0.0;
    bool known_ = false;
};

}  // namespace percussionist::io
