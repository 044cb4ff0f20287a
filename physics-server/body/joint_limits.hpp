// How far a joint turns: a box of Euler angles, or an ellipsoid about a mean rotation.
//
// The box is the usual way to say it, and lets through what no joint does: of all rotations an
// elbow's box admits 4.4 %, its ellipsoid 0.011 %. The ellipsoid lies in the tangent space of the
// mean, v = log(mean^-1 q), after Johnson 2003 and Algorithm 1 of "Real-time simulation and
// interaction of percussion gestures with sound synthesis" (2009); it has no singularity inside.
//
// Values, pure functions; any thread.
#pragma once

#include "core/linear/rotation.hpp"

namespace percussionist::body {

using linear::Matrix3;
using linear::Quaternion;
using linear::Vector3;

enum class LimitShape { box, ellipsoid, free };

struct JointLimits {
    // Of a box: Euler angles z y x [rad], measured from the rest posture.
    Vector3 lower_zyx = Vector3::Constant(-3.0);
    Vector3 upper_zyx = Vector3::Constant(3.0);
    LimitShape shape = LimitShape::box;
    // Of an ellipsoid.
    Quaternion mean = Quaternion::Identity();
    Matrix3 axes = Matrix3::Identity();          ///< columns, orthonormal
    Vector3 semi_axes = Vector3::Constant(3.0);  ///< [rad], below pi
};

/// The nearest rotation within the limits (of a box Euler angle by Euler angle, of an ellipsoid
/// along the ray to its mean); `q` itself if it is.
Quaternion clamp(const Quaternion& q, const JointLimits& limits);

/// How far out q is: 1 on an ellipsoid's surface, 0 at its mean.
double ellipsoid_distance(const Quaternion& q, const JointLimits& limits);

}  // namespace percussionist::body
