#include "body/inverse_dynamics.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace percussionist::body;

TEST_CASE("inverse dynamics: at rest a joint carries the weight of what hangs on it") {
    const Skeleton skeleton = make_skeleton({});
    Placement placement(skeleton);
    forward_kinematics(skeleton, Posture(skeleton), placement);
    Acceleration acceleration(skeleton);
    central_difference(skeleton, placement, placement, placement, 1e-3, acceleration);
    std::vector<Vector3> torques(skeleton.segments.size());
    joint_torques(skeleton, placement, acceleration, torques);
    for (int i = 1; i < skeleton.size(); ++i) {
        Vector3 expected = Vector3::Zero();
        for (int k = i; k < skeleton.size(); ++k) {
            if (!skeleton.moves(i, k)) continue;
            const Vector3 arm = skeleton.segments[k].com_rest - skeleton.segments[i].joint_rest;
            expected += arm.cross(Vector3(0, 0, 9.81 * skeleton.segments[k].mass));
        }
        CHECK((torques[i] - expected).norm() < 1e-9);
    }
}

TEST_CASE("inverse dynamics: a body in free fall needs no torque") {
    const Skeleton skeleton = make_skeleton({});
    const double h = 1e-3;
    const Vector3 fall(0, 0, -0.5 * 9.81 * h * h);
    Placement now(skeleton);
    Placement before = now;
    Placement after = now;
    for (Vector3& com : before.com) com += fall;
    for (Vector3& com : after.com) com += fall;
    Acceleration acceleration(skeleton);
    central_difference(skeleton, before, now, after, h, acceleration);
    std::vector<Vector3> torques(skeleton.segments.size());
    joint_torques(skeleton, now, acceleration, torques);
    for (const Vector3& torque : torques) CHECK(torque.norm() < 1e-5);
}

TEST_CASE("tip mass: a stick on a hand that cannot move is a rod on a hinge") {
    const Skeleton skeleton = make_skeleton({});
    Placement placement(skeleton);
    forward_kinematics(skeleton, Posture(skeleton), placement);
    std::vector<double> stiff(skeleton.segments.size(), 1e9);
    stiff[skeleton.stick_index(Hand::right)] = 0.0;
    TipMass tip_mass(skeleton, Hand::right);
    // 45 g, 0.38 m, held 3 cm from its end: 0.00169 kg m^2 about the hinge, 13.8 g at the tip.
    CHECK(tip_mass(placement, Vector3::UnitZ(), stiff) == doctest::Approx(0.0138).epsilon(0.01));
}

TEST_CASE("tip mass: a stiffer body is heavier") {
    const Skeleton skeleton = make_skeleton({});
    const Placement placement(skeleton);
    TipMass tip_mass(skeleton, Hand::left);
    double last = 0.0;
    for (const double resistance : {0.0, 0.001, 0.01, 0.1}) {
        const std::vector<double> all(skeleton.segments.size(), resistance);
        const double mass = tip_mass(placement, Vector3::UnitZ(), all);
        CHECK(mass > last);
        last = mass;
    }
}
