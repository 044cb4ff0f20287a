// A pose: where a frame's origin lies in another frame, and how its axes are turned in there.
//
// `drum_from_stick` takes a point of the stick's frame into the drum's: p_drum = q p_stick q* + x.
// Poses chain from right to left, a_from_b * b_from_c = a_from_c. All pure: any thread, real-time
// safe.
#pragma once

#include "core/linear/rotation.hpp"

namespace percussionist::linear {

struct Pose {
    Vector3 position = Vector3::Zero();               ///< [m]
    Quaternion orientation = Quaternion::Identity();  ///< unit

    Vector3 operator*(const Vector3& point) const { return orientation * point + position; }
    Pose operator*(const Pose& other) const {
        return {*this * other.position, (orientation * other.orientation).normalized()};
    }
    Pose inverse() const {
        const Quaternion back = orientation.conjugate();
        return {back * -position, back};
    }
};

/// From a (part 0) to b (part 1): the position on a line, the orientation on a great circle. Parts
/// beyond 0 to 1 go on in the same way.
inline Pose interpolate(const Pose& a, const Pose& b, double part) {
    const Vector3 turn = quaternion_log(a.orientation.conjugate() * b.orientation);
    return {a.position + part * (b.position - a.position),
            (a.orientation * quaternion_exp(part * turn)).normalized()};
}

}  // namespace percussionist::linear
