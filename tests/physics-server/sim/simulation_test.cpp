#include "sim/simulation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace percussionist;
using body::Hand;

namespace {

/// One stroke of the right hand at `time`, and what comes of it within 0.4 s after.
std::vector<sim::ContactEvent> one_stroke(double speed, double time,
                                          const sim::SimulationOptions& options = {}) {
    sim::Simulation simulation(options);
    std::vector<sim::ContactEvent> contacts;
    REQUIRE(simulation.strike(Hand::right, time, speed, 0.15 * speed));
    while (simulation.time() < time + 0.4) simulation.step(contacts);
    REQUIRE(simulation.sane());
    return contacts;
}

}  // namespace

TEST_CASE("simulation: a stroke is one contact, at its time and with its speed") {
    for (const double speed : {0.8, 2.0, 4.4}) {
        const auto contacts = one_stroke(speed, 1.0);
        REQUIRE(contacts.size() == 1);
        const sim::ContactEvent& c = contacts[0];
        CHECK(c.hand == Hand::right);
        CHECK(std::abs(c.instant - 1.0) < 0.001);
        CHECK(-c.velocity.z() == doctest::Approx(speed).epsilon(0.02));
        CHECK(c.duration > 0.003);
        CHECK(c.duration < 0.008);
        CHECK_FALSE(c.recontact);
    }
}

TEST_CASE("simulation: impulse is mass times change of velocity") {
    const auto contacts = one_stroke(2.5, 1.0);
    REQUIRE(contacts.size() == 1);
    const sim::ContactEvent& c = contacts[0];
    const double change = c.impulse / c.effective_mass;
    // It comes down with |v| and leaves with a part of it.
    CHECK(change > 1.5 * std::abs(c.velocity.z()));
    CHECK(change < 2.1 * std::abs(c.velocity.z()));
}

TEST_CASE("simulation: a faster stroke presses harder and shorter") {
    double last_force = 0.0;
    double last_duration = 1.0;
    for (double speed = 0.7; speed < 4.6; speed += 0.4) {
        const auto contacts = one_stroke(speed, 1.0);
        REQUIRE(contacts.size() == 1);
        CHECK(-contacts[0].peak_force.z() > last_force);
        CHECK(contacts[0].duration < last_duration + 1e-4);
        last_force = -contacts[0].peak_force.z();
        last_duration = contacts[0].duration;
    }
}

TEST_CASE("simulation: the force does not depend on where in a step the contact begins") {
    double least = 1e9;
    double most = 0.0;
    for (int phase = 0; phase < 8; ++phase) {
        const auto contacts = one_stroke(2.0, 1.0 + phase / 8000.0);
        REQUIRE(contacts.size() == 1);
        const double force = -contacts[0].peak_force.z();
        least = std::min(least, force);
        most = std::max(most, force);
    }
    CHECK(most / least < 1.01);
}

TEST_CASE("simulation: in free air the tip is where it should be, to a millimetre") {
    sim::Simulation simulation({});
    std::vector<sim::ContactEvent> contacts;
    simulation.strike(Hand::right, 1.0, 3.0, 0.4);
    double worst = 0.0;
    while (simulation.time() < 0.99) {
        simulation.step(contacts);
        worst = std::max(worst,
                         (simulation.tip(Hand::right) - simulation.tip_target(Hand::right)).norm());
    }
    CHECK(worst < 0.001);
}

TEST_CASE("simulation: it plays at every rate it offers") {
    for (const double rate : {250.0, 333.0, 500.0, 1000.0, 2000.0, 4000.0}) {
        CAPTURE(rate);
        sim::SimulationOptions options;
        options.rate = rate;
        const auto contacts = one_stroke(2.0, 1.0, options);
        REQUIRE(contacts.size() == 1);
        CHECK(std::abs(contacts[0].instant - 1.0) < 0.003);
    }
}

TEST_CASE("simulation: the same calls give the same contacts, bit for bit") {
    const auto first = one_stroke(3.1, 0.7);
    const auto second = one_stroke(3.1, 0.7);
    REQUIRE(first.size() == 1);
    REQUIRE(second.size() == 1);
    CHECK(first[0].instant == second[0].instant);
    CHECK(first[0].peak_force == second[0].peak_force);
    CHECK(first[0].impulse == second[0].impulse);
}

TEST_CASE("simulation: the papers' law holds the body up, and lags") {
    sim::SimulationOptions options;
    options.control.law = sim::Law::paper;
    sim::Simulation simulation(options);
    std::vector<sim::ContactEvent> contacts;
    simulation.strike(Hand::right, 1.5, 2.0, 0.3);
    double worst = 0.0;
    while (simulation.time() < 3.0) {
        simulation.step(contacts);
        worst = std::max(worst,
                         (simulation.tip(Hand::right) - simulation.tip_target(Hand::right)).norm());
    }
    CHECK(simulation.sane());
    CHECK(worst > 0.02);  // without target velocity and feed-forward
    CHECK(worst < 1.0);
}

TEST_CASE("simulation: a rate that cannot be is refused") {
    sim::SimulationOptions options;
    for (const double rate : {0.0, 249.0, 4001.0, std::numeric_limits<double>::quiet_NaN()}) {
        options.rate = rate;
        CHECK_THROWS_AS(sim::Simulation{options}, std::invalid_argument);
    }
}
