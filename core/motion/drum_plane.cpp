#include "core/motion/drum_plane.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace percussionist::motion {

namespace {

constexpr double kLeastSpread = 0.005;  // [m] of the taps, across their longest line

}  // namespace

FittedPlane fit_plane(std::span<const Vector3> taps, const Vector3& above, double tip_radius) {
    if (taps.size() < 3) {
        throw std::invalid_argument("expected 3 taps or more, got " + std::to_string(taps.size()));
    }
    const auto n = static_cast<double>(taps.size());
    Vector3 middle = Vector3::Zero();
    for (const Vector3& tap : taps) {
        middle += tap / n;
    }
    linear::Matrix3 spread = linear::Matrix3::Zero();
    for (const Vector3& tap : taps) {
        spread += (tap - middle) * (tap - middle).transpose() / n;
    }
    const Eigen::SelfAdjointEigenSolver<linear::Matrix3> axes(spread);
    if (!(axes.eigenvalues()[1] > kLeastSpread * kLeastSpread)) {
        throw std::invalid_argument("expected taps spread over the surface, got them on one line");
    }
    Vector3 z = axes.eigenvectors().col(0);
    z *= z.dot(above - middle) < 0.0 ? -1.0 : 1.0;
    // At right angles to the world's z as well, so level; of a drum that lies flat, the world's x.
    const Vector3 level = Vector3::UnitZ().cross(z);
    const Vector3 forward = Vector3::UnitX() - z * z.x();
    linear::Matrix3 frame;
    frame.col(0) = (level.norm() > 0.1 ? level : forward).normalized();
    frame.col(2) = z;
    frame.col(1) = z.cross(frame.col(0));
    return {{middle - tip_radius * z, linear::Quaternion(frame)},
            std::sqrt(std::max(axes.eigenvalues()[0], 0.0))};
}

}  // namespace percussionist::motion
