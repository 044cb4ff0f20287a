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

/// A force during the sample that has just passed.
void push(ModeBank& bank, double force, const Values& phi) {
    bank.give(std::span(&force, 1), phi);
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
        bank.advance(1);
        push(bank, f, shape);
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
        one.advance(1);
        push(one, 3.0, phi);
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
            one.advance(1);
            REQUIRE(std::abs(one.reading(weights) - velocity) < 1e-12 * most);
        }
        many.advance(ModeBank::kChunk);
        CHECK(many.energy() == doctest::Approx(one.energy()).epsilon(1e-12));
        CHECK(many.reading(weights) == doctest::Approx(one.reading(weights)).epsilon(1e-11));
    }
}

TEST_CASE("forces given at the end of a span have done what each does at its sample") {
    for (const std::size_t samples : {1u, 5u, 16u, 64u}) {
        ModeBank one = bank_of(50);
        const auto phi = some_weights(one);
        push(one, 2.0, phi);
        ModeBank many = one;
        ModeBank::Weights weights{phi, phi, {}};
        one.read_velocity(phi, weights);
        std::vector<double> forces(samples), foreseen(samples), answer(samples), moves(samples);
        many.ring(weights, foreseen);
        many.ring(phi, moves);
        many.answer(phi, weights, answer);
        for (std::size_t n = 0; n < samples; ++n) {
            forces[n] = std::sin(7.0 * static_cast<double>(n));
            for (std::size_t later = n; later < samples; ++later) {
                foreseen[later] += forces[n] * answer[later - n];
            }
            one.advance(1);
            if (n == 0) {
                CHECK(one.displacement(phi) == doctest::Approx(moves[0]).epsilon(1e-12));
            }
            push(one, forces[n], phi);
            REQUIRE(one.reading(weights) == doctest::Approx(foreseen[n]).epsilon(1e-11));
        }
        many.advance(samples);
        many.give(forces, phi);
        CHECK(many.energy() == doctest::Approx(one.energy()).epsilon(1e-12));
        CHECK(many.reading(weights) == doctest::Approx(one.reading(weights)).epsilon(1e-11));
    }
}

TEST_CASE("two ports answer each other alike") {
    const ModeBank bank = bank_of(50);
    const auto phi = some_weights(bank);
    const Values other(bank.padded(), 0.3);
    std::array<double, ModeBank::kSpan> there{}, back{};
    bank.answer(phi, other, there);
    bank.answer(other, phi, back);
    for (std::size_t n = 0; n < there.size(); ++n) {
        CHECK(there[n] == doctest::Approx(back[n]).epsilon(1e-12));
    }
}

TEST_CASE("an acceleration is read as the second difference of displacements has it") {
    ModeBank bank = bank_of(1);
    Values unit(bank.padded(), 0.0), none(bank.padded(), 0.0);
    unit[0] = 1.0;
    push(bank, 1.0, unit);
    ModeBank::Weights weights{unit, unit, unit}, later{unit, unit, unit};
    bank.read_acceleration(unit, none, weights);
    bank.read_acceleration(none, unit, later);
    std::vector<double> q, a;
    for (int i = 0; i < 400; ++i) {
        bank.advance(1);
        q.push_back(bank.displacement(unit));
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
    bank.advance(1);
    push(bank, 1.0, phi);
    for (int i = 0; i < 1000; ++i) {
        for (std::size_t k = 0; k < bank.size(); ++k) {
            const double w = 500.0 + 100.0 * static_cast<double>((i * 7 + k * 3) % 600);
            bank.set(k, {w, 0.1 * w, 0.02});
        }
        bank.advance(1);
    }
    CHECK(std::isfinite(bank.energy()));
}

TEST_CASE("modes that have all but died come to rest, the others stay") {
    ModeBank bank = bank_of(40);
    Values phi(bank.padded(), 1e-15);
    phi[3] = 1.0;
    bank.advance(1);
    push(bank, 1.0, phi);
    CHECK(bank.moving() == bank.padded());
    const double before = bank.energy();
    bank.retire(1e-25);
    CHECK(bank.moving() == ModeBank::kGroup);
    CHECK(bank.energy() == doctest::Approx(before).epsilon(1e-12));
    Values faint(bank.padded(), 1.0);
    faint[3] = 0.0;
    CHECK(bank.displacement(faint) == 0.0);
    push(bank, 1.0, phi);
    CHECK(bank.moving() == bank.padded());
}
