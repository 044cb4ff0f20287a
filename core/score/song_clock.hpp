// Where a song is, for one who plays along with it: by itself, or as somebody tells.
//
// Told that the song was at x at the time t, the clock keeps an estimate of place and rate (a
// fading-memory filter of the first degree; Brookner, "Tracking and Kalman filtering made easy",
// 1998, 1.2.6), with th = exp(-dt / 1 s), dt since it was told before:
//     x += max(1 - th^2, 1 / n) e,    rate += (1 - th)^2 e / dt,    e = told - expected
// of n places told since the last jump. What it shows goes after the estimate without a step, at
// most a fifth faster or slower. An e above 80 ms is no drift but a jump: then it is there at once.
// Between two places told it goes on; the rate stays within 0.5 to 2.
//
// A value; time [s] is an argument, and grows from call to call; no allocation; one thread.
#pragma once

#include <optional>

#include "core/score/tempo_curve.hpp"

namespace percussionist::score {

/// The part of a song that went by in a step.
struct SongStep {
    double from = 0.0, to = 0.0;  ///< [s] of the song
    double rate = 0.0;            ///< of the song's time over that of the world; 0: it stands
    bool jumped = false;          ///< to `to`, from somewhere else: nothing lies between
};

class SongClock {
  public:
    enum class Course { still, alone, led };

    /// From `from` on by itself, at the tempo that holds.
    void play(double now, double from);
    void stop() { course_ = Course::still; }
    /// The song is at `position` at the time `at`, which may be before `now`, or after.
    void told(double now, double at, double position);
    /// It stands, where it is or at `position`, until it is told of again.
    void hold(std::optional<double> position);
    /// Of a song that plays by itself.
    TempoCurve& tempo() { return tempo_; }
    [[nodiscard]] const TempoCurve& tempo() const { return tempo_; }

    SongStep advance(double now);

    [[nodiscard]] Course course() const { return course_; }
    [[nodiscard]] double position() const { return shown_; }
    [[nodiscard]] double rate() const { return rate_; }

  private:
    void jump(double now, double at, double position);
    [[nodiscard]] double expected(double at) const { return x_ + rate_ * (at - at_); }

    Course course_ = Course::still;
    TempoCurve tempo_;
    double now_ = 0.0;             ///< of the last step
    double shown_ = 0.0;           ///< position
    double x_ = 0.0, rate_ = 1.0;  ///< the estimate at at_
    double at_ = 0.0;
    int told_ = 0;  ///< since the last jump
    bool jumped_ = false;
};

}  // namespace percussionist::score
