#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "sim/simulation.hpp"

using namespace percussionist;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Bends the left elbow to and fro, `reach` [rad] both ways.
std::shared_ptr<const body::Clip> bending(const body::Skeleton& skeleton, double reach) {
    std::vector<body::Posture> postures;
    for (int i = 0; i < 200; ++i) {
        body::Posture posture(skeleton);
        posture.joints[skeleton.index("left_forearm")] =
            linear::quaternion_exp({0.0, reach * std::sin(0.06 * i), 0.0});
        postures.push_back(posture);
    }
    return std::make_shared<body::Clip>("bending", skeleton, postures, 0.01);
}

/// The farthest that the simulated elbow bends towards a target of 60 degrees [rad].
double farthest(const body::JointLimits& limits, sim::Law law = sim::Law::implicit) {
    sim::SimulationOptions options;
    options.control.law = law;
    options.control.paper_frequency = 20.0;
    options.head_there = false;
    sim::Simulation simulation(options);
    const int elbow = simulation.skeleton().index("left_forearm");
    simulation.set_limits(elbow, limits);
    simulation.set_tracking(body::Tracking::joints);
    simulation.begin_with(bending(simulation.skeleton(), 60.0 * kDegree));
    std::vector<sim::ContactEvent> none;
    double most = 0.0;
    while (simulation.time() < 2.0) {
        simulation.step(none);
        const auto& turned = simulation.placement().orientation;
        const int above = simulation.skeleton().segments[elbow].parent;
        const body::Quaternion bend = turned[above].conjugate() * turned[elbow];
        most = std::max(most, std::abs(linear::quaternion_log(bend).y()));
    }
    CHECK(simulation.sane());
    return most;
}

}  // namespace

TEST_CASE("joint limits: a target beyond them stops at them, a box of Euler angles") {
    body::JointLimits box;
    box.lower_zyx = {-0.5, -30.0 * kDegree, -0.5};
    box.upper_zyx = {0.5, 30.0 * kDegree, 0.5};
    const double most = farthest(box);
    CHECK(most > 29.0 * kDegree);
    CHECK(most < 33.0 * kDegree);
}

TEST_CASE("joint limits: a target beyond them stops at them, an ellipsoid of rotations") {
    body::JointLimits ellipsoid;
    ellipsoid.shape = body::LimitShape::ellipsoid;
    ellipsoid.semi_axes = {0.5, 30.0 * kDegree, 0.5};
    const double most = farthest(ellipsoid);
    CHECK(most > 29.0 * kDegree);
    CHECK(most < 33.0 * kDegree);
}

TEST_CASE("joint limits: the papers' law keeps them as well, and swings beyond without them") {
    body::JointLimits box;
    box.lower_zyx = {-0.5, -30.0 * kDegree, -0.5};
    box.upper_zyx = {0.5, 30.0 * kDegree, 0.5};
    const double most = farthest(box, sim::Law::paper);
    CHECK(most > 25.0 * kDegree);
    CHECK(most < 33.0 * kDegree);
    body::JointLimits wide;
    wide.shape = body::LimitShape::ellipsoid;
    wide.semi_axes = {1.5, 90.0 * kDegree, 1.5};
    CHECK(farthest(wide, sim::Law::paper) > 45.0 * kDegree);
}

TEST_CASE("joint limits: within them they change nothing") {
    body::JointLimits wide;
    wide.shape = body::LimitShape::ellipsoid;
    wide.semi_axes = {1.5, 61.0 * kDegree, 1.5};
    CHECK(farthest(wide) == doctest::Approx(60.0 * kDegree).epsilon(0.002));
}
