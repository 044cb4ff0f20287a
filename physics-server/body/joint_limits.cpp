#include "body/joint_limits.hpp"

#include "body/posture.hpp"

namespace percussionist::body {

double ellipsoid_distance(const Quaternion& q, const JointLimits& limits) {
    const Vector3 v = linear::quaternion_log(limits.mean.conjugate() * q);
    return (limits.axes.transpose() * v).cwiseQuotient(limits.semi_axes).norm();
}

Quaternion clamp(const Quaternion& q, const JointLimits& limits) {
    if (limits.shape == LimitShape::free) return q;
    if (limits.shape == LimitShape::ellipsoid) {
        const double distance = ellipsoid_distance(q, limits);
        if (distance <= 1.0) return q;
        const Vector3 v = linear::quaternion_log(limits.mean.conjugate() * q);
        return limits.mean * linear::quaternion_exp(v / distance);
    }
    const Vector3 angles = euler_zyx(q);
    const Vector3 inside = angles.cwiseMax(limits.lower_zyx).cwiseMin(limits.upper_zyx);
    return inside == angles ? q : from_euler_zyx(inside);
}

}  // namespace percussionist::body
