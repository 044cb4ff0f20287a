#include "core/motion/gesture_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "core/motion/moving_frame.hpp"

using namespace percussionist::motion;
using namespace percussionist::linear;

namespace {

constexpr double kRadius = 0.2, kTurns = 6.0;  // [m], [rad/s]

/// Round a circle, looking along it.
TimedPose on_circle(double t) {
    const double a = kTurns * t;
    return {t, {{kRadius * std::cos(a), kRadius * std::sin(a), 0.3}, quaternion_exp({0, 0, a})}};
}

}  // namespace

TEST_CASE("on a circle speed, curvature, turning and angular velocity are the circle's") {
    GestureFit fit;
    std::optional<Gesture> g;
    for (int i = 0; i < 60; ++i) {
        g = fit.add(on_circle(i / 120.0));
        CHECK(g.has_value() == (i >= 4));
    }
    CHECK(g->speed == doctest::Approx(kRadius * kTurns).epsilon(1e-3));
    CHECK(g->curvature == doctest::Approx(1 / kRadius).epsilon(1e-2));
    CHECK(g->turning == doctest::Approx(kTurns).epsilon(1e-2));
    CHECK(g->acceleration.norm() == doctest::Approx(kRadius * kTurns * kTurns).epsilon(1e-2));
    CHECK(g->jerk.norm() == doctest::Approx(kRadius * kTurns * kTurns * kTurns).epsilon(0.02));
    CHECK((g->angular_velocity - Vector3(0, 0, kTurns)).norm() < 1e-2);
    CHECK(g->delay == doctest::Approx(0.025));
    CHECK((g->position - on_circle(g->time).pose.position).norm() < 1e-5);
    CHECK(g->direction.dot(g->velocity) == doctest::Approx(g->speed));
}

TEST_CASE("at 30 Hz five poses make the window, and it says how late it is") {
    GestureFit fit;
    std::optional<Gesture> g;
    for (int i = 0; i < 20; ++i) {
        g = fit.add(on_circle(i / 30.0));
    }
    CHECK(g->delay == doctest::Approx(2 / 30.0));
    CHECK(g->speed == doctest::Approx(kRadius * kTurns).epsilon(0.01));
}

TEST_CASE("what stands still has no direction") {
    GestureFit fit;
    std::optional<Gesture> g;
    for (int i = 0; i < 10; ++i) {
        g = fit.add({i / 120.0, {{0.1, 1e-5 * (i % 2), 0.0}, Quaternion::Identity()}});
    }
    CHECK(g->direction.norm() == 0);
    CHECK(g->curvature == 0);
}

TEST_CASE("after a gap a new path begins") {
    GestureFit fit;
    for (int i = 0; i < 10; ++i) {
        fit.add(on_circle(i / 120.0));
    }
    CHECK_FALSE(fit.add(on_circle(1.0)));
}

TEST_CASE("a frame is known between its poses and a little beyond") {
    MovingFrame frame;
    CHECK_FALSE(frame.at(0.0));
    for (int i = 0; i < 10; ++i) {
        frame.add(on_circle(i / 30.0));
    }
    for (const double t : {0.15, 0.2167, 0.29, 0.31}) {
        const Pose truth = on_circle(t).pose;
        CHECK((frame.at(t)->position - truth.position).norm() < 6e-3);
        CHECK(frame.at(t)->orientation.angularDistance(truth.orientation) < 1e-6);
    }
    const Pose end = *frame.at(9.0);
    CHECK((end.position - on_circle(0.35).pose.position).norm() < 0.02);
}
