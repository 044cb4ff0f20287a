// Rotations: between a quaternion and its rotation vector.
//
// A rotation vector is axis times angle [rad]; exp and log are inverse to each other for angles
// below pi. Source: Grassia 1998, "Practical parameterization of rotations using the exponential
// map". All functions are pure: any thread, real-time safe.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace percussionist::linear {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// The unit quaternion that turns by `rotation_vector` [rad].
inline Quaternion quaternion_exp(const Vector3& rotation_vector) {
    const double angle = rotation_vector.norm();
    if (angle < 1e-9) {
        const Vector3 half = 0.5 * rotation_vector;
        return Quaternion(1.0, half.x(), half.y(), half.z()).normalized();
    }
    const Vector3 v = std::sin(0.5 * angle) / angle * rotation_vector;
    return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

/// The rotation vector [rad], of length at most pi, of a unit quaternion (q and -q give the same).
inline Vector3 quaternion_log(const Quaternion& q) {
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    const Vector3 v = sign * q.vec();
    const double sine = v.norm();
    if (sine < 1e-9) {
        return 2.0 * v;
    }
    return 2.0 * std::atan2(sine, sign * q.w()) / sine * v;
}

}  // namespace percussionist::linear
