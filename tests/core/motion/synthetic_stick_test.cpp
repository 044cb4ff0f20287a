#include "core/motion/bodhran_player.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace percussionist::motion;

TEST_CASE("at a stroke's instant its end is one radius from the head, at its place and speed") {
    const std::vector<SyntheticStroke> strokes = {
        {.time = 0.5, .velocity = 2.0, .r = 0.1, .theta = 0.5},
        {.time = 0.7, .velocity = 1.5, .r = 0.05, .theta = 1.0, .end = 1},
        {.time = 0.8, .velocity = 3.0, .r = 0.08, .theta = -0.5},
        {.time = 1.2, .velocity = 1.0, .r = 0.08, .theta = -0.5, .miss = 0.02},
    };
    const SyntheticStick stick({}, strokes);
    for (const auto& stroke : strokes) {
        const auto tip = [&](double t) { return stick.drum_from_stick(t) * stick.tip(stroke.end); };
        CHECK(tip(stroke.time).z() == doctest::Approx(0.0125 + stroke.miss));
        CHECK(std::hypot(tip(stroke.time).x(), tip(stroke.time).y()) ==
              doctest::Approx(stroke.r).epsilon(0.05));
        if (stroke.miss == 0.0) {
            const double speed = (tip(stroke.time - 1e-5).z() - tip(stroke.time - 2e-5).z()) / 1e-5;
            CHECK(speed == doctest::Approx(-stroke.velocity).epsilon(0.01));
            const double turn = stick.turning_time(stroke);
            CHECK(tip(turn).z() < tip(turn - 2e-4).z());
            CHECK(tip(turn).z() < tip(turn + 2e-4).z());
        }
    }
}

TEST_CASE("the bodhran player goes round without a seam, within the tracker's reach") {
    const BodhranPlayer player;
    for (int station = 1; station <= 4; ++station) {
        for (double t = 0.0; t < 20.0; t += 1 / 240.0) {
            const auto a = player.receiver(station, t), b = player.receiver(station, t + 1 / 240.0);
            CHECK((b.position - a.position).norm() < 0.05);
            CHECK(a.position.norm() < 2.0);
            CHECK(a.position.x() > 0.0);
        }
    }
    CHECK(player.strokes(10.0).size() > 50);
}
