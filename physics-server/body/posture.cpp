#include "body/posture.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::body {

Placement::Placement(const Skeleton& skeleton)
    : orientation(skeleton.segments.size(), Quaternion::Identity()),
      joint(skeleton.segments.size()),
      com(skeleton.segments.size()) {
    for (int i = 0; i < skeleton.size(); ++i) {
        joint[i] = skeleton.segments[i].joint_rest;
        com[i] = skeleton.segments[i].com_rest;
    }
}

Vector3 Placement::point(const Skeleton& skeleton, int segment, const Vector3& rest) const {
    return joint[segment] + orientation[segment] * (rest - skeleton.segments[segment].joint_rest);
}

Vector3 Placement::tip(const Skeleton& skeleton, Hand hand) const {
    return point(skeleton, skeleton.stick_index(hand), skeleton.tip_rest(hand));
}

void forward_kinematics(const Skeleton& skeleton, const Posture& posture, Placement& placement) {
    for (int i = 0; i < skeleton.size(); ++i) {
        const Segment& s = skeleton.segments[i];
        if (s.parent < 0) {
            placement.orientation[i] = posture.joints[i];
            placement.joint[i] = s.joint_rest;
        } else {
            placement.orientation[i] = placement.orientation[s.parent] * posture.joints[i];
            placement.joint[i] = placement.point(skeleton, s.parent, s.joint_rest);
        }
        placement.com[i] = placement.point(skeleton, i, s.com_rest);
    }
}

Vector3 euler_zyx(const Quaternion& q) {
    const Matrix3 r = q.toRotationMatrix();
    const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
    return {std::atan2(r(1, 0), r(0, 0)), y, std::atan2(r(2, 1), r(2, 2))};
}

Quaternion from_euler_zyx(const Vector3& zyx) {
    return Quaternion(Eigen::AngleAxisd(zyx[0], Vector3::UnitZ()) *
                      Eigen::AngleAxisd(zyx[1], Vector3::UnitY()) *
                      Eigen::AngleAxisd(zyx[2], Vector3::UnitX()));
}

}  // namespace percussionist::body
