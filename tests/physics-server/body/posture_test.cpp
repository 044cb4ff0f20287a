#include "body/posture.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace percussionist::body;

namespace {

Quaternion any_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

TEST_CASE("posture: identity is the rest posture") {
    const Skeleton skeleton = make_skeleton({});
    Placement placement(skeleton);
    forward_kinematics(skeleton, Posture(skeleton), placement);
    for (int i = 0; i < skeleton.size(); ++i) {
        CHECK((placement.com[i] - skeleton.segments[i].com_rest).norm() < 1e-12);
    }
}

TEST_CASE("posture: bones keep their length whatever the joints do") {
    const Skeleton skeleton = make_skeleton({});
    std::mt19937 random(1);
    Posture posture(skeleton);
    for (Quaternion& q : posture.joints) q = any_rotation(random);
    Placement placement(skeleton);
    forward_kinematics(skeleton, posture, placement);
    for (int i = 1; i < skeleton.size(); ++i) {
        const Segment& s = skeleton.segments[i];
        const double length = (s.joint_rest - skeleton.segments[s.parent].joint_rest).norm();
        CHECK((placement.joint[i] - placement.joint[s.parent]).norm() ==
              doctest::Approx(length).epsilon(1e-12));
    }
}

TEST_CASE("posture: Euler angles name the rotation they came from") {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const Quaternion q = any_rotation(random);
        CHECK(from_euler_zyx(euler_zyx(q)).angularDistance(q) < 1e-7);
    }
}

TEST_CASE("posture: clamping brings inside, leaves inside alone") {
    const JointLimits limits{Vector3(-0.5, -0.8, -0.2), Vector3(0.4, 0.7, 1.0)};
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const Quaternion inside = clamp(any_rotation(random), limits);
        const Vector3 angles = euler_zyx(inside);
        CHECK((angles - limits.lower_zyx).minCoeff() > -1e-9);
        CHECK((limits.upper_zyx - angles).minCoeff() > -1e-9);
        CHECK(clamp(inside, limits).angularDistance(inside) < 1e-7);
    }
}
