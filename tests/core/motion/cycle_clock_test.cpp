#include "core/motion/cycle_clock.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using percussionist::motion::CycleClock;

namespace {

constexpr double kCycle = 1.0 / 120;

/// The worst error of the smoothed instants after the first second.
double worst_error(double true_period, int cycles_a_record) {
    CycleClock clock(kCycle);
    std::mt19937 random(5);
    std::exponential_distribution<> late(1 / 0.0003);
    double worst = 0.0;
    for (int i = 0; i < 3000; i += cycles_a_record) {
        const double instant = 10.0 + i * true_period;
        const double smoothed = clock.smooth(instant + std::min(late(random), 0.002));
        if (i > 120) {
            worst = std::max(worst, std::abs(smoothed - instant));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("instants are those of the grid, though all arrivals are late") {
    CHECK(worst_error(kCycle, 1) < 0.2e-3);
    CHECK(worst_error(kCycle, 4) < 0.3e-3);
}

TEST_CASE("a unit whose quartz is off is followed") {
    CHECK(worst_error(kCycle * 1.0003, 1) < 0.25e-3);
    CHECK(worst_error(kCycle * 0.9997, 1) < 0.25e-3);
}

TEST_CASE("after a pause, or a step of the clock, a new grid begins") {
    CycleClock clock(kCycle);
    for (int i = 0; i < 100; ++i) {
        clock.smooth(i * kCycle);
    }
    CHECK(clock.smooth(10.0013) == 10.0013);
    double smoothed = 0.0;
    for (int i = 1; i < 100; ++i) {
        smoothed = clock.smooth(10.0053 + i * kCycle);
    }
    CHECK(smoothed == doctest::Approx(10.0053 + 99 * kCycle).epsilon(1e-6));
}
