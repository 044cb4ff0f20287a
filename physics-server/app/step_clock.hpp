// Steps of one length locked to the wall clock.
//
// Step k ends at start + k h and is done when the clock reaches that, never earlier, so that the
// time of the steps cannot drift; steps that come late are counted and caught up. If the machine
// was held up for long the start moves on instead: a pause, not a burst of strokes.
#pragma once

#include <cstdint>

#include "app/wall_clock.hpp"

namespace percussionist::app {

/// One thread.
class StepClock {
  public:
    /// Steps of `length` [s].
    StepClock(WallClock& clock, double length);

    /// The first step ends a step's length from now.
    void begin();
    /// Calls `step` for each step whose end has come, as long as it returns true. Those that would
    /// be too far behind are skipped, and said.
    template <class Step>
    void catch_up(Step step) {
        const double now = clock_.now();
        pause_if_far_behind(now);
        while (next_end() <= now) {
            if (now - next_end() > kLate) ++late_;
            if (!step()) break;
            ++done_;
        }
        busy_ += clock_.now() - now;
    }
    /// Returns when the next step's end has come, or a little later.
    void wait() { clock_.sleep_until(next_end()); }

    /// The wall clock at a time of the steps [s].
    [[nodiscard]] double wall(double time) const { return start_ + time; }
    /// And back.
    [[nodiscard]] double time(double wall) const { return wall - start_; }
    [[nodiscard]] int late_steps() const { return late_; }
    /// How long steps were computed since it was last asked [s].
    double take_busy();

  private:
    /// A step this much behind the clock counts as late [s].
    static constexpr double kLate = 0.005;

    void pause_if_far_behind(double now);
    [[nodiscard]] double next_end() const {
        return start_ + static_cast<double>(done_ + 1) * length_;
    }

    WallClock& clock_;
    double length_, start_, busy_ = 0.0;
    std::int64_t done_ = 0;
    int late_ = 0;
};

}  // namespace percussionist::app
