// Follows what a ClockTracker finds, but evenly: what is an even row by one clock is an even row by
// the other, to the last sample.
//
// The tracker's line moves a little with each observation that teaches it more. Clocks that run
// alike, as they do within one machine and nearly so where both are set by a network, are a mere
// offset apart: this line keeps it while the tracker's lies within a tolerance, outside slides
// there, by at most `slew` of the time that passes, and rests again. How near is near enough the
// tracker's own uncertainty says, when the line comes to rest: a network of 50 ms jitter is
// followed to 5 ms, as it needs a lookahead of far more, loopback to a few samples. A constant
// offset of that size is not heard; a changing one is.
//
// Once the tracker is sure, for some seconds, that the clocks run apart, this line runs as the
// tracker's does and is drawn gently towards it. A step of a clock, and what lies beyond `jump` and
// beyond one and a half tolerances, is followed at once, and so is what the tracker learns in the
// half second after it, or in two seconds where it is that uncertain.
//
// Pure, noexcept, without allocation; one thread at a time. Times in seconds.
#pragma once

#include "core/timing/clock_tracker.hpp"

namespace percussionist::timing {

class SteadyLine {
  public:
    struct Settings {
        double least_tolerance = 5e-5;  ///< [s]
        double most_tolerance = 5e-3;   ///< [s]
        double slew = 5e-4;             ///< of time
        double jump = 3e-3;             ///< [s]
    };

    SteadyLine() : SteadyLine(Settings()) {}
    explicit SteadyLine(const Settings& settings) : settings_(settings) {}

    /// After each observation: the tracker, and its x.
    void follow(const ClockTracker& tracker, double x) noexcept;

    double to_y(double x) const noexcept { return y0_ + (x - x0_) + rate_ * (x - x0_); }
    double to_x(double y) const noexcept { return x0_ + (y - y0_) / (1.0 + rate_); }
    bool started() const noexcept { return started_; }
    /// Whether the clocks are taken to run alike.
    bool alike() const noexcept { return alike_; }

  private:
    void take(const ClockTracker& tracker, double x) noexcept;
    void compare(const ClockTracker& tracker, double x) noexcept;
    void hold(const ClockTracker& tracker, double x, double error) noexcept;
    void rest(const ClockTracker& tracker) noexcept;
    void bend(double x, double rate) noexcept;

    Settings settings_;
    bool started_ = false, alike_ = true;
    unsigned steps_ = 0;  // of the tracker
    double x0_ = 0.0, y0_ = 0.0, rate_ = 0.0;
    double tolerance_ = 0.0;
    double settling_until_ = 0.0;
    double doubted_ = 0.0;  // since when the clocks seem to run apart
    bool doubting_ = false;
};

}  // namespace percussionist::timing
