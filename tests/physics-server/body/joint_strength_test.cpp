#include "body/joint_strength.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace percussionist::body;

namespace {

Posture bent(const Skeleton& skeleton, int segment, double angle) {
    Posture posture(skeleton);
    posture.joints[segment] = percussionist::linear::quaternion_exp({0.0, angle, 0.0});
    return posture;
}

double angle_of(const Posture& posture, int segment) {
    return percussionist::linear::quaternion_log(posture.joints[segment]).y();
}

}  // namespace

TEST_CASE("a motion that a joint is strong enough for goes through unchanged") {
    const Skeleton skeleton = make_skeleton({});
    const int shoulder = skeleton.index("left_upper_arm");
    JointStrength strength(skeleton, {shoulder}, 0.001);
    strength.begin(bent(skeleton, shoulder, 0.0), bent(skeleton, shoulder, 0.0));
    for (int i = 0; i < 1000; ++i) {
        Posture wish = bent(skeleton, shoulder, 0.2 * (1.0 - std::cos(0.01 * i)));
        const double asked = angle_of(wish, shoulder);
        CHECK(!strength.hold(wish));
        CHECK(angle_of(wish, shoulder) == asked);
    }
}

TEST_CASE("a jump is followed with the acceleration of the joint's strength, and without a ring") {
    const Skeleton skeleton = make_skeleton({});
    const int shoulder = skeleton.index("left_upper_arm");
    constexpr double kStep = 0.001;
    const double most = skeleton.segments[shoulder].torque_limit /
                        hanging_inertia(skeleton, shoulder) * kStep * kStep;
    JointStrength strength(skeleton, {shoulder}, kStep);
    strength.begin(bent(skeleton, shoulder, 0.0), bent(skeleton, shoulder, 0.0));
    double before = 0.0;
    double now = 0.0;
    double highest = 0.0;
    for (int i = 0; i < 400; ++i) {
        Posture wish = bent(skeleton, shoulder, 0.5);
        strength.hold(wish);
        const double next = angle_of(wish, shoulder);
        CHECK(std::abs(next - 2.0 * now + before) < 1.001 * most);
        before = now;
        now = next;
        highest = std::max(highest, now);
    }
    CHECK(now == doctest::Approx(0.5));
    CHECK(highest < 0.51);
}
