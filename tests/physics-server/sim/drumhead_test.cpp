#include "sim/drumhead.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "sim/impact_forecast.hpp"

using namespace percussionist;
using sim::TouchingTip;

namespace {

/// A free mass falls on the head and is thrown back, moved here by the impulses it is given.
struct Fall {
    std::vector<sim::ContactEvent> contacts;
    double speed_up = 0.0;
};

Fall fall(double speed, double h, double phase) {
    sim::Drumhead head({}, h);
    std::array<TouchingTip, 2> tips;
    tips[0].place = {-0.23, 0.08, 0.004 + phase * speed * h};
    tips[0].velocity = {0.0, 0.0, -speed};
    tips[1].place = {0.0, 0.0, 1.0};
    Fall result;
    for (double t = 0.0; t < 0.03; t += h) {
        const auto impulses = head.step(t, tips, result.contacts);
        tips[0].velocity.z() += impulses[0] / tips[0].mass;
        tips[0].place.z() += h * tips[0].velocity.z();
    }
    result.speed_up = tips[0].velocity.z();
    return result;
}

}  // namespace

TEST_CASE("drumhead: impulse told is impulse given") {
    const Fall f = fall(2.0, 1e-3, 0.3);
    REQUIRE(f.contacts.size() == 1);
    CHECK(f.contacts[0].impulse ==
          doctest::Approx(TouchingTip{}.mass * (f.speed_up + 2.0)).epsilon(0.001));
}

TEST_CASE("drumhead: the instant is found inside the step") {
    for (double phase = 0.0; phase < 1.0; phase += 0.1) {
        const Fall f = fall(2.0, 1e-3, phase);
        REQUIRE(f.contacts.size() == 1);
        const double expected = 0.004 / 2.0 + phase * 1e-3;
        CHECK(std::abs(f.contacts[0].instant - expected) < 21e-6);
    }
}

TEST_CASE("drumhead: long steps and short ones tell of the same contact") {
    const Fall coarse = fall(2.0, 1e-3, 0.0);
    const Fall fine = fall(2.0, 1.0 / 48000, 0.0);
    REQUIRE(coarse.contacts.size() == 1);
    REQUIRE(fine.contacts.size() == 1);
    CHECK(coarse.contacts[0].peak_force.z() ==
          doctest::Approx(fine.contacts[0].peak_force.z()).epsilon(0.003));
    CHECK(coarse.contacts[0].duration == doctest::Approx(fine.contacts[0].duration).epsilon(0.02));
}

TEST_CASE("drumhead: no energy out of nothing") {
    for (const double speed : {0.5, 2.0, 5.0}) {
        const Fall f = fall(speed, 1e-3, 0.5);
        CHECK(f.speed_up > 0.0);
        CHECK(f.speed_up < speed);
    }
}

TEST_CASE("drumhead: a stick that stays pressed in is one contact, not many") {
    sim::Drumhead head({}, 1e-3);
    std::array<TouchingTip, 2> tips;
    tips[0].place = {-0.23, 0.08, 0.0005};
    tips[0].mass = 5.0;  // of a hand that leans on it
    tips[0].velocity = {0.0, 0.0, -0.5};
    tips[1].place = {0.0, 0.0, 1.0};
    std::vector<sim::ContactEvent> contacts;
    for (int i = 0; i < 200; ++i) {
        head.step(i * 1e-3, tips, contacts);
        tips[0].velocity.setZero();
        tips[0].place.z() = -0.003;
    }
    CHECK(contacts.size() == 1);
}

TEST_CASE("drumhead: beside the drum nothing is touched") {
    sim::Drumhead head({}, 1e-3);
    std::array<TouchingTip, 2> tips;
    tips[0].place = {0.5, 0.0, -0.01};
    tips[0].velocity = {0.0, 0.0, -3.0};
    tips[1] = tips[0];
    std::vector<sim::ContactEvent> contacts;
    for (int i = 0; i < 20; ++i) {
        const auto impulses = head.step(i * 1e-3, tips, contacts);
        CHECK(impulses[0] == 0.0);
        CHECK(impulses[1] == 0.0);
    }
    CHECK(contacts.empty());
}

TEST_CASE("impact forecast: what is forecast is what happens to a free mass") {
    const sim::ImpactForecast forecast({}, 1e-3, TouchingTip{}.mass, {-0.23, 0.08, 0.0});
    for (const double speed : {0.8, 1.7, 3.3}) {
        const Fall f = fall(speed, 1.0 / 48000, 0.0);
        REQUIRE(f.contacts.size() == 1);
        CHECK(forecast.rebound(speed).speed == doctest::Approx(f.speed_up).epsilon(0.02));
        CHECK(forecast.rebound(speed).duration ==
              doctest::Approx(f.contacts[0].duration).epsilon(0.06));
    }
}
