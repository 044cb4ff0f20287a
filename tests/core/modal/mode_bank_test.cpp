#include "core/modal/mode_bank.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace percussionist::modal;

namespace {

constexpr double kPeriod = 1.0 / 48000;

ModeBank bank_of(std::size_t size) {
    ModeBank bank(size, kPeriod);
    for (std::size_t k = 0; k < size; ++k) {
        const double i = static_cast<double>(k);
        bank.set(k, {.angular_frequency = 800 + 90 * i, .loss = 4 + i, .mass = 0.01 + 0.001 * i});
    }
    return bank;
}

std::vector<double> some_weights(const ModeBank& bank) {
    std::vector<double> phi(bank.padded(), 0.0);
    for (std::size_t k = 0; k < bank.size(); ++k) {
        phi[k] = std::cos(1.0 + static_cast<double>(k * k));
    }
    return phi;
}

}  // namespace

TEST_CASE("a mode under a constant force moves as the differential equation says") {
    const double w = 2000, s = 30, m = 0.02, f = 0.7, phi = 0.4;
    ModeBank bank(1, kPeriod);
    bank.set(0, {w, s, m});
    std::vector<double> shape(bank.padded(), 0.0), unit(bank.padded(), 0.0);
    shape[0] = phi;
    unit[0] = 1.0;
    // Runge-Kutta, in steps a hundred times shorter, is the slow and obvious way.
    double q = 0.0, v = 0.0;
    const auto acceleration = [&](double x, double u) {
        return f * phi / m - 2 * s * u - w * w * x;
    };
    for (int n = 0; n < 100; ++n) {
        bank.swing(shape);
        bank.push(f, shape);
        const double h = kPeriod / 100;
        for (int i = 0; i < 100; ++i) {
            const double a1 = acceleration(q, v), v1 = v;
            const double a2 = acceleration(q + h / 2 * v1, v + h / 2 * a1), v2 = v + h / 2 * a1;
            const double a3 = acceleration(q + h / 2 * v2, v + h / 2 * a2), v3 = v + h / 2 * a2;
            const double a4 = acceleration(q + h * v3, v + h * a3), v4 = v + h * a3;
            q += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
            v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
        REQUIRE(bank.displacement(unit) == doctest::Approx(q).epsilon(1e-10));
    }
    ModeBank::VelocityWeights weights{std::vector<double>(8), std::vector<double>(8)};
    bank.set_weights(unit, weights);
    CHECK(bank.velocity(weights) == doctest::Approx(v).epsilon(1e-9));
    CHECK(bank.energy() == doctest::Approx(0.5 * m * (v * v + w * w * q * q)).epsilon(1e-9));
}

TEST_CASE("many samples at once are one by one to the last bit, whatever the number of modes") {
    for (const std::size_t size : {1u, 7u, 8u, 100u}) {
        ModeBank one = bank_of(size);
        const auto phi = some_weights(one);
        one.swing(phi);
        one.push(3.0, phi);
        ModeBank many = one;
        ModeBank::VelocityWeights weights{phi, phi};
        one.set_weights(phi, weights);
        std::vector<double> velocities(50);
        many.ring(weights, velocities);
        for (const double velocity : velocities) {
            one.swing(phi);
            REQUIRE(one.velocity(weights) == velocity);
        }
        CHECK(one.energy() == many.energy());
    }
}

TEST_CASE("a bank set anew a thousand times while it swings stays bounded") {
    ModeBank bank = bank_of(40);
    const auto phi = some_weights(bank);
    bank.swing(phi);
    bank.push(1.0, phi);
    for (int i = 0; i < 1000; ++i) {
        for (std::size_t k = 0; k < bank.size(); ++k) {
            const double w = 500.0 + 100.0 * static_cast<double>((i * 7 + k * 3) % 600);
            bank.set(k, {w, 0.1 * w, 0.02});
        }
        bank.swing(phi);
    }
    CHECK(std::isfinite(bank.energy()));
}

TEST_CASE("modes that have all but died come to rest, the others stay") {
    ModeBank bank = bank_of(16);
    std::vector<double> phi(bank.padded(), 1e-150);
    phi[3] = 1.0;
    bank.swing(phi);
    bank.push(1.0, phi);
    const double before = bank.energy();
    bank.rest_the_faint();
    CHECK(bank.energy() == before);
    std::vector<double> faint(bank.padded(), 1.0);
    faint[3] = 0.0;
    CHECK(bank.displacement(faint) == 0.0);
}
