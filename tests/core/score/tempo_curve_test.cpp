#include "core/score/tempo_curve.hpp"

#include <doctest/doctest.h>

#include <random>

using percussionist::score::TempoCurve;

TEST_CASE("tempo curve: at a steady factor the score goes by at that factor") {
    TempoCurve curve;
    curve.begin(10.0, 0.0);
    curve.glide(10.0, 2.0, 0.0);
    CHECK(curve.time_of(4.0) == doctest::Approx(12.0));
    CHECK(curve.position(12.0) == doctest::Approx(4.0));
    CHECK(curve.time_of(-1.0) == doctest::Approx(9.5));
}

TEST_CASE("tempo curve: an accelerando covers the mean of both tempi, and no jump is in it") {
    TempoCurve curve;
    curve.begin(0.0, 0.0);
    curve.glide(0.0, 3.0, 4.0);
    CHECK(curve.position(4.0) == doctest::Approx(8.0));
    CHECK(curve.factor(2.0) == doctest::Approx(2.0));
    CHECK(curve.position(5.0) == doctest::Approx(11.0));
    double last = 0.0;
    for (double x = 0.1; x < 14.0; x += 0.1) {
        const double t = curve.time_of(x);
        CHECK(t > last);
        CHECK(t - last < 0.1 + 1e-9);
        last = t;
    }
}

TEST_CASE("tempo curve: what a rubato hurries it gives back within each period") {
    TempoCurve curve;
    curve.begin(0.0, 0.0);
    curve.sway(0.0, 0.5, 2.0);
    for (int i = 1; i < 5; ++i) CHECK(curve.time_of(2.0 * i) == doctest::Approx(2.0 * i));
    CHECK(curve.time_of(1.0) > 1.1);
}

TEST_CASE(
    "tempo curve: no change moves the present, and time and position are each other's "
    "inverse") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    TempoCurve curve;
    curve.begin(0.0, 0.0);
    double now = 0.0;
    double last = -1.0;
    for (int i = 0; i < 2000; ++i) {
        now += 0.3 * part(random);
        const double x = curve.position(now);
        CHECK(x > last);
        if (random() % 2 == 0) {
            curve.glide(now, 0.1 + 4.0 * part(random), random() % 3 == 0 ? 0.0 : part(random));
        } else {
            curve.sway(now, 0.9 * part(random), 0.5 + 4.0 * part(random));
        }
        CHECK(curve.position(now) == doctest::Approx(x).epsilon(1e-9));
        CHECK(curve.position(curve.time_of(x + 0.7)) == doctest::Approx(x + 0.7).epsilon(1e-9));
        last = x;
    }
}
