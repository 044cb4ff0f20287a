#include "core/modal/mallet.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

using namespace percussionist::modal;

namespace {

constexpr double kPeriod = 1.0 / 48000;

/// A point mass thrown at a rigid wall at 0 from above: how it comes back.
struct Bounce {
    double rebound = 0.0;   ///< [m/s]
    double duration = 0.0;  ///< [s]
    double greatest_compression = 0.0;
    double worst_energy_error = 0.0;  ///< relative
};

Bounce bounce(const Mallet& mallet, double speed, double period = kPeriod) {
    Bounce result;
    double d = 0.0, rate = speed, force = 0.0;
    const double compliance = 0.5 * period * period / mallet.mass;
    const double before = 0.5 * mallet.mass * speed * speed;
    do {
        force = contact_force(mallet, {d, period * rate, compliance, period, rate}, force);
        d += period * rate - compliance * force;
        rate -= period * force / mallet.mass;
        result.duration += period;
        result.greatest_compression = std::max(result.greatest_compression, d);
        const double energy = 0.5 * mallet.mass * rate * rate + contact_potential(mallet, d);
        result.worst_energy_error =
            std::max(result.worst_energy_error, std::abs(energy / before - 1));
    } while (d > 0.0);
    result.duration += d / rate * -1;  // back to where the compression was 0
    result.rebound = -rate;
    return result;
}

/// The speed v after a touch at -speed, of v - ln(1 + mu v) / mu = the same before (v signed).
double wall_rebound(double speed, double mu) {
    const auto level = [&](double v) { return v - std::log1p(mu * v) / mu; };
    double low = 0.0, high = 1 / mu;  // the rebound's sign is minus
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (level(-middle) < level(speed) ? low : high) = middle;
    }
    return low;
}

}  // namespace

TEST_CASE("a lossless bounce keeps its energy to the last digits, however stiff") {
    for (const double stiffness : {1e3, 1e5, 1e7, 1e9, 1e11}) {
        const Bounce b =
            bounce({.mass = 0.02, .stiffness = stiffness, .exponent = 2.3, .dissipation = 0}, 3.0);
        CHECK(b.worst_energy_error < 1e-12);
        CHECK(b.rebound == doctest::Approx(3.0).epsilon(1e-12));
    }
}

TEST_CASE("a lossless bounce lasts and dents as the closed formulas say") {
    const Mallet mallet{.mass = 0.02, .stiffness = 1e7, .exponent = 2.3, .dissipation = 0};
    const double a = mallet.exponent, v = 3.0;
    const double deepest =
        std::pow((a + 1) * mallet.mass * v * v / (2 * mallet.stiffness), 1 / (a + 1));
    const double duration = 2 * deepest / v * std::sqrt(std::numbers::pi) *
                            std::tgamma(1 + 1 / (a + 1)) / std::tgamma(0.5 + 1 / (a + 1));
    CHECK(duration == doctest::Approx(0.00478).epsilon(0.001));
    const Bounce b = bounce(mallet, v);
    CHECK(b.duration == doctest::Approx(duration).epsilon(1e-3));
    CHECK(b.greatest_compression == doctest::Approx(deepest).epsilon(1e-3));
}

TEST_CASE("off a rigid wall, v - ln(1 + mu v) / mu is the same after as before") {
    for (const double mu : {0.5, 5.0, 20.0, 100.0}) {
        for (const double exponent : {1.5, 2.3, 3.5}) {
            const Bounce b = bounce(
                {.mass = 0.02, .stiffness = 1e7, .exponent = exponent, .dissipation = mu}, 3.0);
            CHECK(b.rebound == doctest::Approx(wall_rebound(3.0, mu)).epsilon(1e-4));
        }
        for (const double stiffness : {1e5, 1e9}) {
            const Bounce b = bounce({.mass = 0.02, .stiffness = stiffness, .dissipation = mu}, 3.0);
            CHECK(b.rebound == doctest::Approx(wall_rebound(3.0, mu)).epsilon(1e-4));
        }
    }
    CHECK(bounce({.mass = 0.02, .stiffness = 1e7, .dissipation = 0.5}, 3.0).rebound ==
          doctest::Approx(1.463).epsilon(0.002));
    CHECK(bounce({.mass = 0.02, .stiffness = 1e7, .dissipation = 5}, 3.0).rebound ==
          doctest::Approx(0.200).epsilon(0.005));
    CHECK(bounce({.mass = 0.02, .stiffness = 1e7, .dissipation = 100}, 3.0).rebound ==
          doctest::Approx(0.010).epsilon(0.01));
}

TEST_CASE("the force is finite and never pulls, whatever comes in") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-12, 4), sign(-1, 1);
    const auto any = [&] { return std::copysign(std::pow(10, exponent(random)), sign(random)); };
    for (int i = 0; i < 100000; ++i) {
        const Mallet mallet{.stiffness = std::pow(10, exponent(random) + 8),
                            .exponent = 3 + 2 * sign(random),
                            .dissipation = std::abs(any())};
        const double f = contact_force(mallet, {any(), any(), std::abs(any()), kPeriod}, any());
        REQUIRE(std::isfinite(f));
        REQUIRE(f >= 0.0);
    }
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    CHECK(contact_force({}, {nan, 1, 1e-9, kPeriod}, 0) == 0.0);
    CHECK(contact_force({}, {1, nan, 1e-9, kPeriod}, 0) == 0.0);
    CHECK(std::isfinite(contact_force({}, {inf, inf, 1e-9, kPeriod}, inf)));
    CHECK(std::isfinite(contact_force({}, {1, 1, 1e-9, kPeriod}, nan)));
}

TEST_CASE("the force solves its equation, from whatever guess") {
    const Mallet mallet{.dissipation = 0.0};
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 10000; ++i) {
        const ContactStep step{1e-3 * unit(random), 2e-4 * (unit(random) - 0.5),
                               1e-8 * std::pow(10, -3 * unit(random)), kPeriod};
        const double force = contact_force(mallet, step, 0.0);
        const double y = step.free_change - step.compliance * force;
        const double work = contact_potential(mallet, step.compression + y) -
                            contact_potential(mallet, step.compression);
        const double energy = contact_potential(mallet, 1e-3) + std::abs(force * y);
        REQUIRE(std::abs(force * y - work) < 1e-12 * energy);
        REQUIRE(contact_force(mallet, step, 1e5 * unit(random)) ==
                doctest::Approx(force).epsilon(1e-9));
    }
}

TEST_CASE("the linear contact is the solution of its equation, and as lossless") {
    const Mallet linear{.mass = 0.02, .stiffness = 3000, .exponent = 1, .dissipation = 0};
    const Bounce b = bounce(linear, 3.0);
    CHECK(b.worst_energy_error < 1e-12);
    CHECK(b.duration ==
          doctest::Approx(std::numbers::pi * std::sqrt(linear.mass / linear.stiffness))
              .epsilon(1e-3));
    Mallet nearly = linear;
    nearly.exponent = 1.0000001;
    for (const double free : {1e-5, -1e-5, 3e-4}) {
        const ContactStep step{1e-4, free, 1e-8, kPeriod};
        CHECK(contact_force(linear, step, 0.0) ==
              doctest::Approx(contact_force(nearly, step, 0.0)).epsilon(1e-5));
    }
}

TEST_CASE("a mallet that cannot be is refused by name") {
    CHECK_THROWS_AS(check(Mallet{.mass = 0}), std::invalid_argument);
    CHECK_THROWS_AS(check(Mallet{.stiffness = -1}), std::invalid_argument);
    CHECK_THROWS_AS(check(Mallet{.exponent = 0.5}), std::invalid_argument);
    CHECK_THROWS_AS(check(Mallet{.dissipation = std::nan("")}), std::invalid_argument);
    CHECK_NOTHROW(check(Mallet{}));
}
