#include "core/modal/struck_membrane.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace percussionist::modal;
using std::numbers::pi;

namespace {

constexpr double kRate = 48000;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Decay kLossless{.t60_low = kInfinite, .t60_high = kInfinite};

Mallet lossless(double stiffness = 4e7, double exponent = 2.3) {
    return {.mass = 0.03, .stiffness = stiffness, .exponent = exponent, .dissipation = 0};
}

Striker falling(const Mallet& mallet, double speed) {
    return {.mallet = mallet, .position = 0.0, .velocity = -speed};
}

/// The speed after a touch at `speed` with v - ln(1 + mu v) / mu as before (the rebound's v below
/// 0).
double wall_rebound(double speed, double mu) {
    const auto level = [&](double v) { return v - std::log1p(mu * v) / mu; };
    double low = 0.0, high = 1 / mu;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (level(-middle) < level(speed) ? low : high) = middle;
    }
    return low;
}

/// A short push at place 0: a light mallet thrown on, then taken away.
void knock(StruckMembrane& head) {
    Striker striker[] = {falling(lossless(), 2.0)};
    for (int i = 0; i < 2400; ++i) {
        head.step(striker);
    }
}

}  // namespace

TEST_CASE("a lossless drum and its mallet keep their energy to 1e-10 over many touches") {
    for (const double stiffness : {1e6, 1e7, 1e9, 1e11}) {
        StruckMembrane head({}, kLossless, 150, kRate);
        head.place(0, 0.12, 0.3);
        Striker striker[] = {falling(lossless(stiffness), 3.0)};
        const double before = head.energy(striker);
        double worst = 0.0;
        for (int i = 0; i < 48000; ++i) {
            head.step(striker);
            worst = std::max(worst, std::abs(head.energy(striker) / before - 1));
        }
        CHECK(worst < 1e-10);
        CHECK(head.bank().energy() > 1e-3 * before);
    }
}

TEST_CASE("two sticks at once, apart and on one spot, keep the energy too") {
    for (const double apart : {0.0, 0.001, 0.2}) {
        StruckMembrane head({}, kLossless, 120, kRate);
        head.place(0, 0.1, 0.0);
        head.place(1, 0.1 + apart, 0.0);
        Striker sticks[] = {falling(lossless(1e8), 3.0), falling(lossless(3e6, 1.7), 1.0)};
        const double before = head.energy(sticks);
        double worst = 0.0;
        for (int i = 0; i < 9600; ++i) {
            head.step(sticks);
            worst = std::max(worst, std::abs(head.energy(sticks) / before - 1));
        }
        CHECK(worst < 1e-10);
    }
}

TEST_CASE("with losses the energy never grows, at no sample") {
    const Mallet hard[] = {{.stiffness = 1e9},
                           {.stiffness = 1e9, .exponent = 1.5, .dissipation = 20},
                           {.stiffness = 1e11, .exponent = 1.5, .dissipation = 100}};
    StruckMembrane head({}, {}, 120, kRate);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int stroke = 0; stroke < 60; ++stroke) {
        head.place(0, 0.3 * unit(random), 6 * unit(random));
        head.place(1, 0.3 * unit(random), 6 * unit(random));
        Striker sticks[] = {falling({.dissipation = 3 * unit(random)}, 5 * unit(random)),
                            falling(hard[stroke % 3], 5 * unit(random))};
        for (auto i : {0, 1}) {
            sticks[i].position = head.displacement(i);
        }
        double energy = head.energy(sticks);
        for (int i = 0; i < 480; ++i) {
            head.step(sticks);
            const double now = head.energy(sticks);
            REQUIRE(now <= energy * (1 + 1e-12));
            REQUIRE(sticks[0].force >= 0.0);
            energy = now;
        }
    }
}

TEST_CASE("beyond the rim a striker meets a rigid wall") {
    StruckMembrane head({}, {}, 50, kRate);
    head.place(0, 0.4, 0.0);
    Striker striker[] = {
        falling({.mass = 0.02, .stiffness = 1e7, .exponent = 2.3, .dissipation = 5}, 3.0)};
    do {
        head.step(striker);
    } while (striker[0].position < 0.0);
    CHECK(striker[0].velocity == doctest::Approx(0.200).epsilon(0.005));
    CHECK(head.bank().energy() == 0.0);
}

TEST_CASE("off the wall, v - ln(1 + mu v) / mu is what it was, however short the touch") {
    const double speed = 3.0;
    for (const double exponent : {1.0, 1.5, 2.3, 3.5}) {
        for (const double stiffness : {1e7, 1e9, 1e11}) {
            for (const double mu : {0.5, 5.0, 20.0, 100.0}) {
                if (exponent == 1.0 && stiffness == 1e11) {
                    continue;  // it would take steps of a thousandth of a sample
                }
                StruckMembrane head({}, {}, 1, kRate);
                head.place(0, 0.4, 0.0);
                Striker striker[] = {falling(
                    {.mass = 0.02, .stiffness = stiffness, .exponent = exponent, .dissipation = mu},
                    speed)};
                striker[0].position = 0.7 * speed / kRate;  // it touches within a sample
                do {
                    head.step(striker);
                } while (striker[0].position < 0.0 || striker[0].velocity < 0.0);
                CAPTURE(exponent);
                CAPTURE(stiffness);
                CAPTURE(mu);
                CHECK(striker[0].velocity ==
                      doctest::Approx(wall_rebound(speed, mu)).epsilon(1e-3));
            }
        }
    }
}

TEST_CASE("a hard lossy mallet leaves a head as it does when all is stepped sixteen times finer") {
    const auto after = [](double rate, int steps) {
        StruckMembrane head({.radius = 0.3}, {}, 60, rate);
        head.place(0, 0.1, 0.0);
        Striker striker[] = {
            falling({.mass = 0.001, .stiffness = 1e11, .exponent = 1.5, .dissipation = 20}, 3.0)};
        for (int i = 0; i < steps; ++i) {
            head.step(striker);
        }
        return std::pair(striker[0].velocity, head.bank().energy());
    };
    // The same modes at both rates.
    const auto coarse = after(kRate, 12);
    const auto fine = after(16 * kRate, 16 * 12);
    CHECK(coarse.first == doctest::Approx(fine.first).epsilon(1e-4));
    CHECK(coarse.second == doctest::Approx(fine.second).epsilon(1e-4));
}

TEST_CASE("modes ring at the frequencies of theory and die in the time set") {
    const Decay decay{.t60_low = 0.9, .t60_high = 0.2};
    StruckMembrane head({}, decay, 60, kRate);
    for (const std::size_t k : {0u, 5u, 40u}) {
        // The mode alone: its own weight reads it; the energy of all others is irrelevant to it.
        head.rest();
        head.place(0, 0.15, 0.2);
        knock(head);
        Values only(head.bank().padded(), 0.0);
        only[k] = 1.0;
        const double w = head.modes()[k].angular_frequency;
        const double s = loss_at(decay, head.modes()[0].angular_frequency, w);
        // Demodulated at the frequency of theory, the phase stands still; the level falls as set.
        Striker away[] = {{.mallet = {}, .position = 1.0}};
        double re[2] = {}, im[2] = {};
        const int window = 4800;
        for (int part = 0; part < 2; ++part) {
            for (int i = 0; i < window; ++i) {
                const double t = (part * window + i) / kRate;
                const double q = head.bank().displacement(only) * std::exp(s * t);
                const double hann = 1 - std::cos(2 * pi * i / window);
                re[part] += hann * q * std::cos(w * t);
                im[part] += hann * q * std::sin(w * t);
                head.step(away);
            }
        }
        const double turned = std::atan2(im[1], re[1]) - std::atan2(im[0], re[0]);
        const double frequency_error = std::remainder(turned, 2 * pi) / (window / kRate) / w;
        CHECK(std::abs(frequency_error) < 1e-3);
        CHECK(std::hypot(re[1], im[1]) / std::hypot(re[0], im[0]) ==
              doctest::Approx(1.0).epsilon(0.005));
    }
    CHECK(std::log(1000.0) / loss_at(decay, 100, 100) == doctest::Approx(0.9));
    CHECK(std::log(1000.0) / loss_at(decay, 100, 2 * pi * 2000) == doctest::Approx(0.2));
}

TEST_CASE("what A feels of B is what B feels of A") {
    StruckMembrane head({}, {}, 100, kRate);
    const auto answer = [&](double r1, double t1, double r2, double t2) {
        head.rest();
        head.place(0, r1, t1);
        const auto weights = head.shapes(r2, t2);
        // A rigid wall's worth of mass: the same push wherever it is.
        Striker push[] = {{.mallet = {.mass = 1e6, .stiffness = 1e3, .exponent = 1}}};
        std::vector<double> heard;
        push[0].position = -0.01;
        for (int i = 0; i < 200; ++i) {
            head.step(std::span(push, i == 0 ? 1 : 0));
            heard.push_back(head.bank().displacement(weights) / push[0].force);
        }
        return heard;
    };
    const auto there = answer(0.05, 0.1, 0.25, 2.0);
    const auto back = answer(0.25, 2.0, 0.05, 0.1);
    for (std::size_t i = 0; i < there.size(); ++i) {
        CHECK(there[i] == doctest::Approx(back[i]).epsilon(1e-10).scale(1e-6));
    }
}

TEST_CASE("a mode struck on its node stays silent, and is not heard there") {
    StruckMembrane head({}, {}, 30, kRate);
    head.place(0, 0.0, 0.0);  // the middle: a node of every mode with diameters
    knock(head);
    for (std::size_t k = 0; k < 30; ++k) {
        Values only(head.bank().padded(), 0.0);
        only[k] = 1.0;
        if (head.modes()[k].diameters > 0) {
            CHECK(head.bank().displacement(only) == 0.0);
        } else {
            CHECK(head.bank().displacement(only) != 0.0);
        }
    }
    const auto at_rim = head.shapes(0.33, 1.0);
    CHECK(std::all_of(at_rim.begin(), at_rim.end(), [](double x) { return x == 0.0; }));
}

TEST_CASE("a stick stays on the head for some milliseconds") {
    StruckMembrane head({}, {}, 120, kRate);
    head.place(0, 0.1, 0.0);
    Striker striker[] = {falling({}, 2.0)};
    int touching = 0;
    for (int i = 0; i < 960; ++i) {
        head.step(striker);
        touching += striker[0].force > 0.0;
    }
    CHECK(touching / kRate > 0.002);
    CHECK(touching / kRate < 0.012);
}

TEST_CASE("a new tuning while it swings leaves displacement and velocity where they are") {
    StruckMembrane head({}, {}, 60, kRate);
    knock(head);
    const auto weights = head.shapes(0.1, 1.0);
    const double before = head.bank().displacement(weights);
    head.tune({.tension = 5000}, {});
    CHECK(head.bank().displacement(weights) == before);
    CHECK(head.modes()[0].angular_frequency ==
          doctest::Approx(membrane_modes({.tension = 5000}, 1)[0].angular_frequency));
    StruckMembrane fresh({.radius = 0.2, .tension = 900}, {}, 60, kRate);
    head.tune({.radius = 0.2, .tension = 900}, {});
    CHECK(head.modes().back().modal_mass == fresh.modes().back().modal_mass);
    CHECK_THROWS_AS(head.tune({.tension = -5}, {}), std::invalid_argument);
    CHECK(head.modes()[0].radius == 0.2);
}

TEST_CASE("strikers and places out of range do no harm") {
    StruckMembrane head({}, {}, 20, kRate);
    CHECK_THROWS_AS(head.place(StruckMembrane::kMaxStrikers, 0, 0), std::invalid_argument);
    CHECK_THROWS_AS(head.place(0, -1, 0), std::invalid_argument);
    CHECK_THROWS_AS(head.place(0, std::nan(""), 0), std::invalid_argument);
    std::vector<Striker> many(20);
    many[3].position = std::nan("");
    many[4].velocity = -1e200;
    many[5].velocity = -1e6;
    for (int i = 0; i < 1000; ++i) {
        head.step(many);
    }
    CHECK(std::isfinite(head.bank().energy()));
    CHECK_THROWS_AS(StruckMembrane({}, {}, 20, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(StruckMembrane({}, Decay{.t60_low = 0.1, .t60_high = 1}, 20, kRate),
                    std::invalid_argument);
}
