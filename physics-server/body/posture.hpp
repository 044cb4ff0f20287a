// A posture (the rotation of each joint) and where it puts the segments.
//
// Real-time safe once constructed: forward kinematics allocates nothing.
#pragma once

#include <vector>

#include "body/skeleton.hpp"

namespace percussionist::body {

/// The rotation of each segment against its parent; identity is the rest posture. Entry 0 (the
/// pelvis) is its orientation in the world.
struct Posture {
    std::vector<Quaternion> joints;
    explicit Posture(const Skeleton& skeleton)
        : joints(skeleton.segments.size(), Quaternion::Identity()) {}
};

/// Where the segments are, world frame.
struct Placement {
    std::vector<Quaternion> orientation;
    std::vector<Vector3> joint;  ///< [m]
    std::vector<Vector3> com;    ///< [m]
    explicit Placement(const Skeleton& skeleton);

    /// A point given at rest (world, `rest`) that moves with `segment`.
    [[nodiscard]] Vector3 point(const Skeleton& skeleton, int segment, const Vector3& rest) const;
    [[nodiscard]] Vector3 tip(const Skeleton& skeleton, Hand hand) const;
};

void forward_kinematics(const Skeleton& skeleton, const Posture& posture, Placement& placement);

/// Euler angles z y x [rad] of a rotation q = Rz Ry Rx, and back.
Vector3 euler_zyx(const Quaternion& q);
Quaternion from_euler_zyx(const Vector3& zyx);

}  // namespace percussionist::body
