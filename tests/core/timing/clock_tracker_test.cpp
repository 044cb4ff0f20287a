#include "core/timing/clock_tracker.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using percussionist::timing::ClockTracker;

namespace {

constexpr double kSample = 1.0 / 48000;

/// A sender's clock that drifts, over a network whose packets are late by up to `lateness`.
struct Network {
    double drift = 50e-6;
    double lateness = 10e-3;
    double rate = 20.0;  // packets a second
    unsigned seed = 1;
    double step_at = 1e9, step = 0.0;  // of the local clock

    double local(double x) const {
        return 5e5 + (x - 1000.0) * (1.0 + drift) + (x >= step_at ? step : 0.0);
    }
    /// Lets the tracker see the packets from one time to another; what its line is off by.
    std::vector<double> run(ClockTracker& tracker, double from, double to) const {
        std::mt19937_64 random(seed + static_cast<unsigned>(from));
        std::uniform_real_distribution<double> late(0.0, lateness);
        std::vector<double> errors;
        for (double x = 1000.0 + from; x < 1000.0 + to; x += 1.0 / rate) {
            tracker.observe(x, local(x) + late(random));
            errors.push_back(tracker.to_y(x + 0.03) - local(x + 0.03));
        }
        return errors;
    }
};

double deviation(const std::vector<double>& errors) {
    double sum = 0.0, squares = 0.0;
    for (const double e : errors) {
        sum += e;
        squares += e * e;
    }
    const auto n = static_cast<double>(errors.size());
    return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
}

double worst(const std::vector<double>& errors) {
    double most = 0.0;
    for (const double e : errors) {
        most = std::max(most, std::abs(e));
    }
    return most;
}

/// The mean over several networks that differ by their chance alone.
double mean_deviation(Network network, double from, double to) {
    double sum = 0.0;
    constexpr int kRuns = 10;
    for (int i = 0; i < kRuns; ++i) {
        network.seed = 100U * static_cast<unsigned>(i);
        ClockTracker tracker;
        network.run(tracker, 0.0, from);
        sum += deviation(network.run(tracker, from, to));
    }
    return sum / kRuns;
}

}  // namespace

TEST_CASE("a drift of 50 ppm under jitter of loopback: within a tenth of a sample") {
    const Network loopback{.lateness = 50e-6};
    CHECK(mean_deviation(loopback, 3.0, 20.0) < 0.1 * kSample);
}

TEST_CASE("a drift of 50 ppm under 10 ms of jitter: within 3 samples") {
    CHECK(mean_deviation({.rate = 100.0}, 3.0, 20.0) < 3.0 * kSample);
    CHECK(mean_deviation({.rate = 20.0}, 20.0, 80.0) < 3.0 * kSample);
}

TEST_CASE("the rate is found, up to hundreds of ppm") {
    for (const double drift : {-300e-6, 0.0, 50e-6, 400e-6}) {
        CAPTURE(drift);
        ClockTracker tracker;
        Network{.drift = drift, .lateness = 1e-3}.run(tracker, 0.0, 60.0);
        CHECK(tracker.rate() == doctest::Approx(drift).epsilon(0.01).scale(1e-3));
    }
}

TEST_CASE("what is late does not matter as long as something is in time") {
    Network network{.lateness = 0.0};
    ClockTracker tracker;
    network.run(tracker, 0.0, 10.0);
    std::mt19937_64 random(3);
    std::exponential_distribution<double> late(1.0 / 0.02);
    for (double x = 1010.0; x < 1060.0; x += 0.05) {
        tracker.observe(x, network.local(x) + (random() % 3 == 0 ? 0.0 : late(random)));
        REQUIRE(std::abs(tracker.to_y(x) - network.local(x)) < 3.0 * kSample);
    }
    CHECK(tracker.steps() == 0);
}

TEST_CASE("the first observation locks; one line for all of a short time") {
    ClockTracker tracker;
    CHECK(!tracker.started());
    tracker.observe(7.0, 1007.5);
    CHECK(tracker.started());
    CHECK(tracker.to_y(7.03) == doctest::Approx(1007.53));
    CHECK(tracker.to_x(tracker.to_y(8.25)) == doctest::Approx(8.25));
}

TEST_CASE("after a step either way, of milliseconds or of an hour, it is locked again within 1 s") {
    for (const double lateness : {50e-6, 1e-3, 10e-3}) {
        for (const double step : {-3600.0, -0.5, -0.03, 0.03, 0.2, 0.5, 3600.0}) {
            if (std::abs(step) < 5.0 * lateness) {
                continue;  // cannot be told from lateness so soon
            }
            CAPTURE(lateness);
            CAPTURE(step);
            const Network network{.lateness = lateness, .step_at = 1020.0, .step = step};
            ClockTracker tracker;
            network.run(tracker, 0.0, 21.0);
            CHECK(worst(network.run(tracker, 21.0, 22.0)) < std::max(lateness, 2e-5));
            CHECK(tracker.steps() >= 1);
            CHECK(tracker.rate() == doctest::Approx(50e-6).epsilon(0.5));
        }
    }
}

TEST_CASE("many drop-outs: the clock is found again each time, the rate kept") {
    const Network network{.lateness = 1e-4, .rate = 750.0};
    ClockTracker tracker({.step = 1e-3});
    double local_late = 0.0;
    std::mt19937_64 random(5);
    for (int second = 0; second < 40; ++second) {
        Network later = network;
        later.step_at = 0.0;
        later.step = local_late;
        later.run(tracker, second, second + 0.7);
        CHECK(worst(later.run(tracker, second + 0.7, second + 1.0)) < 1e-4);
        local_late += 2e-3 + 1e-2 * static_cast<double>(random() % 100) / 100.0;
    }
    CHECK(tracker.rate() == doctest::Approx(50e-6).epsilon(0.3));
}

TEST_CASE("after a long silence it goes on where the line leads") {
    const Network network{.lateness = 1e-4};
    ClockTracker tracker;
    network.run(tracker, 0.0, 60.0);
    CHECK(worst(network.run(tracker, 360.0, 361.0)) < 3e-4);
}

TEST_CASE("a rate that changes slowly is followed") {
    ClockTracker tracker;
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> late(0.0, 1e-4);
    double y = 0.0;
    for (double x = 0.0; x < 300.0; x += 0.05) {
        y += 0.05 * (1.0 + 2e-6 * std::sin(x / 60.0));
        tracker.observe(x, y + late(random));
        if (x > 5.0) {
            REQUIRE(std::abs(tracker.to_y(x) - y) < 2.0 * kSample);
        }
    }
}

TEST_CASE("an hour on, it is as exact as in the first minute") {
    const Network network{.lateness = 1e-3};
    ClockTracker tracker;
    network.run(tracker, 0.0, 3600.0);
    CHECK(deviation(network.run(tracker, 3600.0, 3660.0)) < 3.0 * kSample);
}

TEST_CASE("it restarts from a new place, the rate kept") {
    const Network network{.lateness = 1e-4};
    ClockTracker tracker;
    network.run(tracker, 0.0, 30.0);
    tracker.restart();
    CHECK(!tracker.started());
    tracker.observe(0.0, 3.0);
    CHECK(tracker.to_y(0.0) == 3.0);
    CHECK(tracker.rate() == doctest::Approx(50e-6).epsilon(0.1));
}
