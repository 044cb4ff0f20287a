#include "body/inverse_kinematics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace percussionist::body;

namespace {

ArmTargets targets_at(const Skeleton& skeleton, double height) {
    ArmTargets targets;
    for (const Hand hand : {Hand::left, Hand::right}) {
        ArmTarget& target = targets[static_cast<int>(hand)];
        target.tip = skeleton.tip_rest(hand);
        target.tip.z() += height - 0.10;
        target.grip_height = target.tip.z() + 0.03 - 0.5 * height;
    }
    return targets;
}

}  // namespace

TEST_CASE("inverse kinematics: the tips follow a stroke to a tenth of a millimetre") {
    const Skeleton skeleton = make_skeleton({});
    InverseKinematics kinematics(skeleton);
    Posture posture(skeleton);
    Placement placement(skeleton);
    for (int i = 0; i < 100; ++i) kinematics.solve(targets_at(skeleton, 0.0), posture, placement);
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double height = 0.15 * (1.0 - std::cos(0.02 * i));
        worst = std::max(worst, kinematics.solve(targets_at(skeleton, height), posture, placement));
    }
    CHECK(worst < 1e-4);
}

TEST_CASE("inverse kinematics: no joint is bent beyond its limits") {
    const Skeleton skeleton = make_skeleton({});
    InverseKinematics kinematics(skeleton);
    Posture posture(skeleton);
    Placement placement(skeleton);
    ArmTargets far = targets_at(skeleton, 0.0);
    far[0].tip += Vector3(1.0, 2.0, 1.0);  // no arm is so long
    far[1].tip += Vector3(-1.0, 0.5, -0.5);
    for (int i = 0; i < 300; ++i) kinematics.solve(far, posture, placement);
    for (int i = 1; i < skeleton.size(); ++i) {
        const Segment& s = skeleton.segments[i];
        CHECK(clamp(posture.joints[i], s.limits).angularDistance(posture.joints[i]) < 1e-6);
        CHECK(std::isfinite(posture.joints[i].norm()));
    }
}
