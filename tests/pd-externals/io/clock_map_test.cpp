#include "io/clock_map.hpp"

#include <doctest/doctest.h>

#include <random>

using percussionist::io::ClockMap;

namespace {

constexpr double kTick = 64 / 48000.0;

}  // namespace

TEST_CASE("late ticks do not move the map, drift does") {
    ClockMap map;
    std::mt19937 random(2);
    std::exponential_distribution<> late(1 / 0.0005);
    double worst = 0.0;
    for (int i = 0; i < 40000; ++i) {
        const double logical = i * kTick;
        const double steady = 100.0 + logical * (1 + 50e-6);
        map.observe(steady + late(random), logical);
        if (i > 4000) {
            worst = std::max(worst, std::abs(map.logical(steady) - logical));
        }
    }
    CHECK(worst < 0.3e-3);
}

TEST_CASE("a step of either clock is followed at once") {
    ClockMap map;
    map.observe(10.0, 0.0);
    map.observe(11.0, 0.1);
    CHECK(map.logical(11.0) == doctest::Approx(0.1));
    map.observe(11.0, 5.0);
    CHECK(map.logical(11.0) == doctest::Approx(5.0));
}
