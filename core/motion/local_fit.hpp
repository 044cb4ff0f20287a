// A polynomial through a few points of a path, by least squares: derivatives without differences.
//
//     p(t) = sum_i c_i (t - origin)^i, degree 0 to 3, each axis for itself
//
// Derivatives out of a fit carry less of the tracker's noise than differences do: the velocity in
// the middle of n points that are dt apart and have noise s each is off by s sqrt(12 / n^3) / dt.
// Times need not be even. No allocation; pure; real-time safe.
#pragma once

#include <array>
#include <span>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

using linear::Vector3;

struct PathPoint {
    double time = 0.0;                   ///< [s]
    Vector3 position = Vector3::Zero();  ///< [m]
};

class LocalFit {
  public:
    /// The degree is lowered where there are not more points than it needs; no points, no motion.
    LocalFit(std::span<const PathPoint> points, int degree, double origin) noexcept;

    Vector3 position(double time) const noexcept { return derivative(0, time); }
    Vector3 velocity(double time) const noexcept { return derivative(1, time); }      ///< [m/s]
    Vector3 acceleration(double time) const noexcept { return derivative(2, time); }  ///< [m/s^2]
    Vector3 jerk() const noexcept { return derivative(3, origin_); }                  ///< [m/s^3]

    /// Of the points about the curve, per axis, for the freedom that is left; 0 if none is [m].
    double residual() const noexcept { return residual_; }

  private:
    Vector3 derivative(int order, double time) const noexcept;
    std::array<Vector3, 4> coefficients_{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                                         Vector3::Zero()};
    double origin_;
    double residual_ = 0.0;
};

}  // namespace percussionist::motion
