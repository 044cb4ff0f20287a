// When a moment of a score comes, at a tempo that changes while it is played.
//
// The tempo is a factor of the score's own. It may glide from one factor to another (accelerando,
// ritardando: linear in time), and sway about that within each few seconds of the score (rubato:
// what is hurried is given back). With x the score's time and u the time that glides alone measure,
//     u = x + c + (d P / 2 pi) (1 - cos(2 pi x / P)),    du/dx = 1 + d sin(2 pi x / P),
//     u' = f(t), f linear from f0 to f1 within the glide, then f1,
// so that t(x) is in closed form, and rises strictly as d < 1 and f > 0. Every change leaves the
// present where it is: time never jumps.
//
// A value; pure; no allocation; one thread.
#pragma once

namespace percussionist::score {

class TempoCurve {
  public:
    /// From now on [s] the score is at x [s], at the factor and sway that hold.
    void begin(double now, double x);

    /// Reaches `factor` (above 0) within `seconds` (at once if 0).
    void glide(double now, double factor, double seconds);
    /// Depth 0 to 0.9 of the tempo, over `period` seconds of the score (above 0).
    void sway(double now, double depth, double period);

    /// When the score is at x [s].
    [[nodiscard]] double time_of(double x) const { return time_at(swayed(x)); }
    /// Where the score is at t [s].
    [[nodiscard]] double position(double t) const;
    /// The factor of glides at t, without sway.
    [[nodiscard]] double factor(double t) const;
    [[nodiscard]] double goal() const { return to_; }
    [[nodiscard]] double depth() const { return depth_; }
    [[nodiscard]] double period() const { return period_; }

  private:
    [[nodiscard]] double swayed(double x) const;
    [[nodiscard]] double time_at(double u) const;
    [[nodiscard]] double measured(double t) const;

    double start_ = 0.0;                 ///< of the glide [s]
    double from_u_ = 0.0;                ///< u at its start [s]
    double from_ = 1.0, to_ = 1.0;       ///< factors
    double length_ = 0.0;                ///< of the glide [s]
    double depth_ = 0.0, period_ = 4.0;  ///< of the sway; [s]
    double shift_ = 0.0;                 ///< c [s]
};

}  // namespace percussionist::score
