#include "body/path_repair.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "body/stroke_path.hpp"

using namespace percussionist;
using linear::Vector3;

namespace {

constexpr double kDt = 0.004;

/// Synthetic strokes of a tip at 250 Hz, with the noise of a camera system.
motion::Trajectory synthetic_strokes(const char* gesture, double noise) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, noise);
    motion::Trajectory path;
    body::StrokePath strokes;
    const body::StrokeShape shape = body::find_gesture(body::built_in_gestures(), gesture)->shape;
    int asked = 0;
    for (int i = 0; i < 1000; ++i) {
        const double t = kDt * i;
        if (asked < 3 && 0.8 + asked * 1.1 - t < 0.75) {
            body::Aim aim;
            aim.time = 0.8 + asked++ * 1.1;
            aim.shape = shape;
            aim.rebound = {0.5 * shape.impact, 0.005};
            strokes.aim(t, aim);
        }
        const double z = strokes.tip(t).position;
        const Vector3 shake(normal(random), normal(random), normal(random));
        path.samples.push_back({t, Vector3(0.6 - 0.5 * z * z, 0.08, 0.9 + z) + shake});
    }
    return path;
}

/// Synthetic: down at `speed`, up at `back` of it, the turn at any instant between two samples.
motion::Trajectory synthetic_turn(double speed, double back, double instant) {
    motion::Trajectory path;
    for (int i = -40; i < 40; ++i) {
        const double t = kDt * i - instant;
        const double z = t < 0.0 ? -speed * t : back * speed * t;
        path.samples.push_back({kDt * (i + 40), {0.2 * t, 0.0, z}});
    }
    return path;
}

double worst_against(const motion::Trajectory& path, const motion::Trajectory& truth) {
    double worst = 0.0;
    for (const auto& s : path.samples) {
        const auto at = static_cast<std::size_t>(std::lround(s.time / kDt));
        worst = std::max(worst, (s.position - truth.samples[at].position).norm());
    }
    return worst;
}

}  // namespace

TEST_CASE("a stick that turns within one frame is no glitch, up to 15 m/s") {
    for (const double speed : {1.0, 4.0, 9.0, 15.0}) {
        for (const double back : {0.1, 0.5, 0.9}) {
            for (const double instant : {0.0, 0.001, 0.002, 0.0039}) {
                CAPTURE(speed);
                CAPTURE(back);
                CAPTURE(instant);
                motion::Trajectory path = synthetic_turn(speed, back, instant);
                CHECK(body::repair(path).bridged == 0);
            }
        }
    }
}

TEST_CASE("clean synthetic strokes of every nuance pass untouched, with noise and without") {
    for (const body::Gesture& g : body::built_in_gestures()) {
        for (const double noise : {0.0, 0.0001, 0.0005}) {
            CAPTURE(g.name);
            CAPTURE(noise);
            motion::Trajectory path = synthetic_strokes(g.name.c_str(), noise);
            CHECK(body::repair(path).bridged == 0);
        }
    }
}

TEST_CASE("synthetic glitches of 1 to 15 samples, from 12 mm on, are found and bridged") {
    const motion::Trajectory clean = synthetic_strokes("accent", 0.0002);
    std::mt19937 random(11);
    for (const double size : {0.012, 0.03, 0.06, 0.5}) {
        for (const int length : {1, 2, 5, 15}) {
            CAPTURE(size);
            CAPTURE(length);
            motion::Trajectory path = clean;
            int wrong = 0;
            for (std::size_t at = 35; at + 20 < path.samples.size(); at += 61) {
                const Vector3 away =
                    size * Vector3(1.0, static_cast<double>(random() % 3) - 1.0, 0.5).normalized();
                for (int k = 0; k < length; ++k, ++wrong) path.samples[at + k].position += away;
            }
            const int bridged = body::repair(path).bridged;
            CHECK(bridged >= wrong);
            CHECK(bridged <= wrong + wrong / 10 + 2);
            CHECK(worst_against(path, clean) < 0.5 * size);
        }
    }
}

TEST_CASE(
    "a path that stays where it jumped to is there; one that begins or ends in a jump is not") {
    motion::Trajectory moved = synthetic_strokes("legato", 0.0);
    for (std::size_t i = 500; i < moved.samples.size(); ++i) moved.samples[i].position.x() += 0.3;
    CHECK(body::repair(moved).bridged == 0);
    const motion::Trajectory clean = synthetic_strokes("legato", 0.0);
    motion::Trajectory ends = clean;
    for (const std::size_t i : {0, 1, 2, 996, 997, 998, 999}) {
        ends.samples[i].position.y() += 0.2;
    }
    CHECK(body::repair(ends).bridged == 7);
    CHECK(worst_against(ends, clean) < 1e-9);
}

TEST_CASE("the noise of a path is found under its strokes") {
    CHECK(body::path_noise(synthetic_strokes("legato", 0.0005)) ==
          doctest::Approx(0.0005).epsilon(0.15));
}
