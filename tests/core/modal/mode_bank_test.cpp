#include "core/modal/mode_bank.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
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

std::array<ModeBank::Push, 1> pushing(double force, const Values& phi) {
    return {{{force, phi.data()}}};
}

Values some_weights(const ModeBank& bank) {
    Values phi(bank.padded(), 0.0);
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
    Values shape(bank.padded(), 0.0), unit(bank.padded(), 0.0);
    shape[0] = phi;
    unit[0] = 1.0;
    // Runge-Kutta, in steps a hundred times shorter, is the slow and obvious way.
    double q = 0.0, v = 0.0;
    const auto acceleration = [&](double x, double u) {
        return f * phi / m - 2 * s * u - w * w * x;
    };
    for (int n = 0; n < 100; ++n) {
        bank.swing({}, shape);
        bank.push(pushing(f, shape));
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
    ModeBank::Weights weights{unit, unit, {}};
    bank.read_velocity(unit, weights);
    CHECK(bank.reading(weights) == doctest::Approx(v).epsilon(1e-9));
    CHECK(bank.energy() == doctest::Approx(0.5 * m * (v * v + w * w * q * q)).epsilon(1e-9));
}

TEST_CASE("what is foreseen of many samples is what they are one by one, for any number of modes") {
    for (const std::size_t size : {1u, 7u, 16u, 100u}) {
        ModeBank one = bank_of(size);
        const auto phi = some_weights(one);
        one.swing({}, phi);
        one.push(pushing(3.0, phi));
        ModeBank many = one;
        ModeBank::Weights weights{phi, phi, {}};
        one.read_velocity(phi, weights);
        std::vector<double> velocities(ModeBank::kChunk);
        many.ring(weights, velocities);
        double most = 0.0;
        for (const double velocity : velocities) {
            most = std::max(most, std::abs(velocity));
        }
        for (const double velocity : velocities) {
            one.swing({}, phi);
            REQUIRE(std::abs(one.reading(weights) - velocity) < 1e-12 * most);
        }
        many.advance(ModeBank::kChunk);
        CHECK(many.energy() == doctest::Approx(one.energy()).epsilon(1e-12));
        CHECK(many.reading(weights) == doctest::Approx(one.reading(weights)).epsilon(1e-11));
    }
}

TEST_CASE("a push waiting for the next swing is a push before it, to the last bit") {
    ModeBank now = bank_of(50);
    const auto phi = some_weights(now);
    now.swing({}, phi);
    ModeBank later = now;
    for (int i = 0; i < 10; ++i) {
        now.push(pushing(2.0 + i, phi));
        const double at_once = now.swing({}, phi);
        const auto waiting = pushing(2.0 + i, phi);
        REQUIRE(later.swing(waiting, phi) == at_once);
    }
}

TEST_CASE("an acceleration is read as the second difference of displacements has it") {
    ModeBank bank = bank_of(1);
    Values unit(bank.padded(), 0.0), none(bank.padded(), 0.0);
    unit[0] = 1.0;
    bank.push(pushing(1.0, unit));
    ModeBank::Weights weights{unit, unit, unit}, later{unit, unit, unit};
    bank.read_acceleration(unit, none, weights);
    bank.read_acceleration(none, unit, later);
    std::vector<double> q, a;
    for (int i = 0; i < 400; ++i) {
        q.push_back(bank.swing({}, unit));
        a.push_back(bank.reading(weights));
    }
    for (std::size_t i = 1; i + 1 < q.size(); ++i) {
        const double second = (q[i - 1] - 2 * q[i] + q[i + 1]) / (kPeriod * kPeriod);
        CHECK(a[i] == doctest::Approx(second).epsilon(1e-3).scale(1e-3 * 800 * 800 * q[0]));
    }
    // A quarter of a period later: in quadrature.
    CHECK(std::hypot(bank.reading(weights), bank.reading(later)) ==
          doctest::Approx(bank.mode(0).angular_frequency * bank.mode(0).angular_frequency *
                          std::sqrt(2 * bank.energy() / bank.mode(0).mass) /
                          bank.mode(0).angular_frequency)
              .epsilon(0.02));
}

TEST_CASE("a bank set anew a thousand times while it swings stays bounded") {
    ModeBank bank = bank_of(40);
    const auto phi = some_weights(bank);
    bank.swing({}, phi);
    bank.push(pushing(1.0, phi));
    for (int i = 0; i < 1000; ++i) {
        for (std::size_t k = 0; k < bank.size(); ++k) {
            const double w = 500.0 + 100.0 * static_cast<double>((i * 7 + k * 3) % 600);
            bank.set(k, {w, 0.1 * w, 0.02});
        }
        bank.swing({}, phi);
    }
    CHECK(std::isfinite(bank.energy()));
}

TEST_CASE("modes that have all but died come to rest, the others stay") {
    ModeBank bank = bank_of(40);
    Values phi(bank.padded(), 1e-15);
    phi[3] = 1.0;
    bank.swing({}, phi);
    bank.push(pushing(1.0, phi));
    CHECK(bank.moving() == bank.padded());
    const double before = bank.energy();
    bank.retire(1e-25);
    CHECK(bank.moving() == ModeBank::kGroup);
    CHECK(bank.energy() == doctest::Approx(before).epsilon(1e-12));
    Values faint(bank.padded(), 1.0);
    faint[3] = 0.0;
    CHECK(bank.displacement(faint) == 0.0);
    bank.push(pushing(1.0, phi));
    CHECK(bank.moving() == bank.padded());
}
