#include "body/stroke_path.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace percussionist::body;

namespace {

constexpr double kTick = 1e-4;

Aim aim_at(double time, double speed) {
    return {time, speed, 0.12 * speed, {0.75 * speed, 0.006}};
}

/// How much faster than `least` a state changes somewhere along [t0, t1], read off its neighbours.
struct Roughness {
    double position = 0.0, velocity = 0.0;
};
Roughness roughness(const StrokePath& path, double t0, double t1) {
    Roughness worst;
    for (double t = t0; t < t1; t += kTick) {
        const PathState a = path.tip(t);
        const PathState b = path.tip(t + kTick);
        const double mean_velocity = 0.5 * (a.velocity + b.velocity);
        const double mean_acceleration = 0.5 * (a.acceleration + b.acceleration);
        worst.position =
            std::max(worst.position, std::abs(b.position - a.position - mean_velocity * kTick));
        worst.velocity =
            std::max(worst.velocity, std::abs(b.velocity - a.velocity - mean_acceleration * kTick));
    }
    return worst;
}

}  // namespace

TEST_CASE("stroke path: the tip meets the head at its time and with its speed") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> interval(0.1, 2.0);
    std::uniform_real_distribution<double> speed(0.7, 4.5);
    StrokePath path;
    double now = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Aim aim = aim_at(now + interval(random), speed(random));
        REQUIRE(path.aim(now, aim));
        CHECK(std::abs(path.tip(aim.time).position) < 1e-9);
        CHECK(path.tip(aim.time).velocity == doctest::Approx(-aim.speed));
        now = aim.time + kTick;
    }
}

TEST_CASE("stroke path: above the head until the impact, and never out of reach") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> interval(0.1, 2.0);
    std::uniform_real_distribution<double> speed(0.7, 4.5);
    StrokePath path;
    double now = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Aim aim = aim_at(now + interval(random), speed(random));
        path.aim(now, aim);
        for (double t = now + 0.008; t < aim.time; t += 0.001) {
            CHECK(path.tip(t).position > 0.0);
            CHECK(path.tip(t).position < 0.65);
            // A stick of 0.35 m from grip to tip cannot rise further than that above the hand.
            CHECK(path.tip(t).position - path.hand(t).position < 0.31);
        }
        now = aim.time + kTick;
    }
}

TEST_CASE("stroke path: position, velocity and acceleration never jump") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> interval(0.1, 1.5);
    StrokePath path;
    double now = 0.0;
    for (int i = 0; i < 50; ++i) {
        const Aim aim = aim_at(now + interval(random), 3.0);
        path.aim(now, aim);
        const Roughness rough = roughness(path, now, aim.time + 0.005);
        CHECK(rough.position < 2e-6);
        CHECK(rough.velocity < 2e-2);
        now = aim.time + kTick;
    }
}

TEST_CASE("stroke path: a new aim bends the path under way without a jump") {
    StrokePath path;
    REQUIRE(path.aim(0.0, aim_at(1.0, 3.0)));
    const PathState before = path.tip(0.7);
    REQUIRE(path.aim(0.7, aim_at(1.2, 2.0)));
    const PathState after = path.tip(0.7);
    CHECK(after.position == doctest::Approx(before.position));
    CHECK(after.velocity == doctest::Approx(before.velocity));
    CHECK(after.acceleration == doctest::Approx(before.acceleration));
    CHECK(path.tip(1.2).velocity == doctest::Approx(-2.0));
}

TEST_CASE("stroke path: what cannot be reached in time is refused and changes nothing") {
    StrokePath path;
    REQUIRE(path.aim(0.0, aim_at(1.0, 3.0)));
    CHECK_FALSE(path.aim(0.5, aim_at(0.5 + 0.9 * StrokePath::kShortestAim, 3.0)));
    CHECK(path.impact() == 1.0);
    CHECK(path.tip(1.0).velocity == doctest::Approx(-3.0));
}

TEST_CASE("stroke path: at rest the tip waits above the head") {
    StrokePath path;
    path.aim(0.0, aim_at(1.0, 3.0));
    path.rest(0.5);
    CHECK_FALSE(path.aiming(0.6));
    CHECK(path.tip(5.0).position == doctest::Approx(StrokePath::kWaitingHeight));
    CHECK(path.tip(5.0).velocity == doctest::Approx(0.0));
}

namespace {

Aim gesture_at(double time, const char* name) {
    Aim aim;
    aim.time = time;
    aim.shape = find_gesture(built_in_gestures(), name)->shape;
    aim.rebound = {0.7 * aim.shape->impact, 0.006};
    return aim;
}

/// The first height at which the tip stops to rise after t.
double rebound_after(const StrokePath& path, double t) {
    t += 0.01;
    while (path.tip(t).velocity > 0.0) t += kTick;
    return path.tip(t).position;
}

}  // namespace

TEST_CASE("stroke path: the rebound is the nuance's own, whatever follows in time") {
    for (const Gesture& g : built_in_gestures()) {
        CAPTURE(g.name);
        StrokePath path;
        path.aim(0.0, gesture_at(1.0, g.name.c_str()));
        path.aim(1.0 + kTick, gesture_at(3.0, "legato"));
        CHECK(rebound_after(path, 1.0) == doctest::Approx(g.shape.rebound).epsilon(0.02));
    }
}

TEST_CASE("stroke path: the end of a stroke prepares the next without a stop") {
    for (const double interval : {0.35, 0.5, 0.7, 0.8}) {
        CAPTURE(interval);
        StrokePath path;
        path.aim(0.0, gesture_at(1.0, "legato"));
        path.aim(1.0 + kTick, gesture_at(1.0 + interval, "vertical-accent"));
        double raised = 0.0;
        for (double t = 1.02; t < 1.0 + interval; t += 0.001) {
            raised = std::max(raised, path.tip(t).position);
        }
        int still = 0;  // below where it is raised to [ms]
        for (double t = 1.02; path.tip(t).position < 0.9 * raised; t += 0.001) {
            if (std::abs(path.tip(t).velocity) < 0.05) ++still;
        }
        CHECK(still == 0);
    }
}

TEST_CASE(
    "stroke path: a stroke moved so late that it would go through the head cannot be followed") {
    StrokePath path;
    path.aim(0.0, gesture_at(1.0, "vertical-accent"));
    CHECK(path.can_be_followed(0.01));
    StrokePath later = path;
    later.aim(0.98, gesture_at(1.15, "vertical-accent"));
    CHECK(!later.can_be_followed(0.98));
}
