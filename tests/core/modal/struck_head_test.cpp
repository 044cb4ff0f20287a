#include "core/modal/struck_head.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/modal/struck_membrane.hpp"

using namespace percussionist::modal;
using std::numbers::pi;

namespace {

constexpr double kRate = 48000;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Decay kLossless{.t60_low = kNever, .t60_high = kNever};

Striker falling(double stiffness, double speed) {
    return {.mallet = {.mass = 0.02, .stiffness = stiffness, .dissipation = 0}, .velocity = -speed};
}

/// Energy's largest rise from one sample to the next, over the energy at the start.
template <class Between>
double largest_gain(StruckHead& head, std::span<Striker> strikers, int samples, Between between) {
    const double start = head.energy(strikers);
    double last = start, gain = 0.0;
    for (int i = 0; i < samples; ++i) {
        between(i);
        last = std::min(last, head.energy(strikers));
        head.step(strikers);
        const double now = head.energy(strikers);
        gain = std::max(gain, (now - last) / start);
        last = now;
    }
    return gain;
}

/// Frequency [Hz] of what is read, by its zero crossings upwards.
double pitch(StruckHead& head, const ModeBank::Weights& weights, int samples) {
    double first = 0.0, last = 0.0;
    int crossings = 0;
    double before = head.bank().reading(weights);
    for (int i = 0; i < samples; ++i) {
        head.step({});
        const double now = head.bank().reading(weights);
        if (before < 0.0 && now >= 0.0) {
            last = i + before / (before - now);
            first = crossings++ == 0 ? last : first;
        }
        before = now;
    }
    return (crossings - 1) / (last - first) * kRate;
}

/// The lowest mode alone is listened to.
ModeBank::Weights lowest(const StruckHead& head) {
    Values none(head.bank().padded(), 0.0);
    ModeBank::Weights weights{none, none, {}};
    weights.q[0] = 1.0;
    return weights;
}

}  // namespace

TEST_CASE("eight lossless strikers and a drum keep their energy to 1e-10, from 1 to 4096 modes") {
    for (const std::size_t modes : {1u, 16u, 240u, 4096u}) {
        for (const double stiffness : {1e5, 1e8, 1e11}) {
            StruckMembrane head({.tension = 300}, kLossless, modes, kRate);
            std::array<Striker, 8> strikers;
            for (std::size_t i = 0; i < 8; ++i) {
                head.place(i, 0.04 * static_cast<double>(i), 0.7 * static_cast<double>(i));
                strikers[i] = falling(stiffness, 1.0 + 0.3 * static_cast<double>(i));
            }
            const double before = head.energy(strikers);
            double worst = 0.0;
            for (int i = 0; i < (modes > 1000 ? 600 : 4800); ++i) {
                head.step(strikers);
                if (i % 20 == 0) {
                    worst = std::max(worst, std::abs(head.energy(strikers) / before - 1));
                }
            }
            CAPTURE(modes);
            CAPTURE(stiffness);
            CHECK(worst < 1e-10);
        }
    }
}

TEST_CASE("hands that come, press, move and go only ever take energy") {
    StruckMembrane head({}, kLossless, 120, kRate);
    head.place(0, 0.1, 0.0);
    std::array<Striker, 1> striker{falling(1e8, 4.0)};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    const double gain = largest_gain(head, striker, 6000, [&](int i) {
        if (i % 97 == 50) {
            head.lay(random() % 4, {.r = 0.3 * unit(random),
                                    .theta = 6 * unit(random),
                                    .area = std::pow(10, -4 + 2.5 * unit(random)),
                                    .pressure = std::pow(10, 1 + 4 * unit(random))});
        }
    });
    CHECK(gain < 1e-12);
    CHECK(head.bank().energy() < 1e-3);
}

TEST_CASE("a hand damps the modes that move under it, and spares those with a node there") {
    StruckMembrane head({}, kLossless, 40, kRate);
    head.lay(0, {.r = 0.0, .theta = 0.0, .area = 3e-4, .pressure = 3000});
    for (std::size_t k = 0; k < 3; ++k) {
        head.rest();
        Values alone(head.bank().padded(), 0.0);
        alone[k] = 1.0;
        const double newton = 1.0;
        head.bank().give(std::span(&newton, 1), alone);
        const double before = head.bank().energy();
        for (int i = 0; i < 4800; ++i) {
            head.step({});
        }
        const double left = head.energy({}) / before;
        // Mode 0 has its belly in the middle, modes 1 and 2 a node.
        CHECK((k == 0 ? left < 0.5 : left > 0.999));
    }
}

TEST_CASE("the harder a hand presses, the higher the pitch") {
    double last = 0.0;
    for (const double pressure : {0.0, 500.0, 2000.0, 8000.0}) {
        StruckMembrane head({}, {}, 60, kRate);
        const auto ear = lowest(head);
        head.lay(0, {.r = 0.15, .theta = 0.0, .area = 2e-3, .pressure = pressure});
        head.place(0, 0.1, 2.0);
        std::array<Striker, 1> striker{falling(1e8, 1.0)};
        for (int i = 0; i < 480; ++i) {
            head.step(striker);
        }
        const double hertz = pitch(head, ear, 4800);
        CAPTURE(pressure);
        CHECK(hertz > last);
        last = hertz;
    }
}

TEST_CASE("a skin that stretches keeps its energy, and is the higher the wider it swings") {
    double soft = 0.0;
    for (const double speed : {0.2, 10.0}) {
        StruckMembrane head({.stretch = 6e5}, kLossless, 100, kRate);
        const auto ear = lowest(head);
        head.place(0, 0.05, 0.0);
        std::array<Striker, 1> striker{falling(1e8, speed)};
        const double before = head.energy(striker);
        double worst = 0.0;
        for (int i = 0; i < 4800; ++i) {
            head.step(striker);
            worst = std::max(worst, std::abs(head.energy(striker) / before - 1));
        }
        CHECK(worst < 1e-10);
        striker[0].position = 10;
        const double hertz = pitch(head, ear, 9600);
        CHECK(hertz > 1.02 * soft);
        soft = hertz;
    }
    // Softly struck it swings as the ideal membrane does.
    StruckMembrane head({.stretch = 6e5}, kLossless, 100, kRate);
    const auto ear = lowest(head);
    head.place(0, 0.05, 0.0);
    std::array<Striker, 1> striker{falling(1e8, 0.01)};
    for (int i = 0; i < 960; ++i) {
        head.step(striker);
    }
    CHECK(pitch(head, ear, 24000) ==
          doctest::Approx(head.modes()[0].angular_frequency / (2 * pi)).epsilon(1e-3));
}

TEST_CASE("sticky surfaces hold each other back, and only take energy by it") {
    const auto left_after = [](double stickiness) {
        StruckMembrane head({}, kLossless, 60, kRate);
        head.place(0, 0.1, 0.0);
        std::array<Striker, 1> striker{falling(1e8, 0.5)};
        striker[0].mallet.stickiness = stickiness;
        CHECK(largest_gain(head, striker, 2000, [](int) {}) < 1e-12);
        return striker[0].velocity;
    };
    CHECK(left_after(1.0) < 0.95 * left_after(0.0));
    CHECK(left_after(3.0) < left_after(1.0));
}

TEST_CASE("a driven striker goes where it is driven, whatever the head does") {
    StruckMembrane head({}, {}, 60, kRate);
    head.place(0, 0.1, 0.0);
    std::array<Striker, 1> striker{{{.position = 0.001, .velocity = -0.5}}};
    striker[0].mallet.mass = kDriven;
    for (int i = 0; i < 480; ++i) {
        head.step(striker);
        REQUIRE(striker[0].position == doctest::Approx(0.001 - 0.5 * (i + 1) / kRate));
    }
    CHECK(striker[0].force > 0.0);
    CHECK(head.displacement(0) < -0.0025);
    CHECK(head.displacement(0) > striker[0].position);
}

TEST_CASE("a constant force dents the head as statics has it") {
    StruckMembrane head({}, Decay{.t60_low = 0.05, .t60_high = 0.02}, 200, kRate);
    head.place_force(0.1, 0.0);
    head.place(0, 0.2, 1.0);
    std::array<Striker, 1> away{{{.position = 1.0}}};
    for (int i = 0; i < 24000; ++i) {
        head.step(away, -2.0);
    }
    double dent = 0.0;
    for (std::size_t k = 0; k < head.modes().size(); ++k) {
        const auto& mode = head.modes()[k];
        const double w = head.bank().mode(k).angular_frequency;
        dent -= 2.0 * mode.shape(0.1, 0.0) * mode.shape(0.2, 1.0) / (mode.modal_mass * w * w);
    }
    CHECK(head.displacement(0) == doctest::Approx(dent).epsilon(1e-4));
}

TEST_CASE("what a pickup reads of a step is what the bank reads after it") {
    for (const double stretch : {0.0, 5e5}) {
        StruckHead head(Resonator(Membrane{.stretch = stretch}, Decay{}, {.count = 80}), kRate);
        head.lay(1, {});
        head.place(0, 0.1, 0.0);
        const auto shape = head.shapes(0.2, 1.0);
        ModeBank::Weights weights{shape, shape, {}};
        head.bank().read_velocity(shape, weights);
        head.listen(0, weights);
        head.listen(2, weights);
        std::array<Striker, 1> striker{falling(1e11, 3.0)};
        striker[0].mallet.exponent = 1.5;
        striker[0].mallet.dissipation = 20;
        for (int i = 0; i < 200; ++i) {
            head.step(striker);
            const double reading = head.reading(0);
            REQUIRE(head.reading(2) == reading);
            if (i % 7 < 3) {
                REQUIRE(reading ==
                        doctest::Approx(head.bank().reading(weights)).epsilon(1e-9).scale(1e-6));
            }
        }
    }
}
