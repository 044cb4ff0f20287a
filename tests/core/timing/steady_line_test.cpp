#include "core/timing/steady_line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using percussionist::timing::ClockTracker;
using percussionist::timing::SteadyLine;

namespace {

constexpr double kSample = 1.0 / 48000;

/// A sender's clock over a network, followed evenly.
struct Link {
    double drift = 0.0;
    double jitter = 50e-3;
    double rate = 70.0;  // packets a second that arrive
    unsigned seed = 1;
    ClockTracker tracker = ClockTracker();
    SteadyLine line = SteadyLine();
    double step = 0.0;

    double local(double x) const { return 5e5 + x * (1.0 + drift) + step; }
    /// Where the line puts events of every 10 ms against the truth.
    std::vector<double> run(double from, double to) {
        std::mt19937_64 random(seed + static_cast<unsigned>(from));
        std::uniform_real_distribution<double> late(0.0, jitter + 1e-12);
        std::vector<double> errors;
        double next = from;
        for (double x = from; x < to; x += 1.0 / rate) {
            for (; line.started() && next < x; next += 0.01) {
                errors.push_back(line.to_y(next) - local(next));
            }
            tracker.observe(x, local(x) + late(random));
            line.follow(tracker, x);
        }
        return errors;
    }
};

double most(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}
double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

}  // namespace

TEST_CASE("steady line: clocks that run alike, whatever the jitter: after 3 s events stay even") {
    for (const double jitter : {1e-4, 1e-3, 1e-2, 5e-2}) {
        CAPTURE(jitter);
        int uneven = 0;
        for (unsigned seed = 1; seed <= 100; ++seed) {
            Link link{.jitter = jitter, .seed = seed};
            link.run(0.0, 3.0);
            const auto errors = link.run(3.0, 63.0);
            uneven += most(errors) - least(errors) > 1e-3 * kSample ? 1 : 0;
            CHECK(most(errors) < 0.2 * jitter + 5e-5);
        }
        CHECK(uneven <= 3);
    }
}

TEST_CASE("steady line: a handful of ever less late packets is no clock that runs fast") {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        CAPTURE(seed);
        Link sparse{.jitter = 1e-2, .rate = 14.0, .seed = seed};
        sparse.run(0.0, 3.0);
        const auto errors = sparse.run(3.0, 33.0);
        CHECK(most(errors) < 4e-3);
        CHECK(least(errors) > -4e-3);
    }
}

TEST_CASE(
    "steady line: a sender 50 ppm off is followed; from event to event, 100 ms apart, "
    "nine in ten are even to a tenth of a sample") {
    for (const double jitter : {1e-4, 1e-2, 5e-2}) {
        CAPTURE(jitter);
        Link link{.drift = 50e-6, .jitter = jitter};
        link.run(0.0, 60.0);
        const auto errors = link.run(60.0, 120.0);
        CHECK(most(errors) < 2e-3);
        CHECK(least(errors) > -2e-3);
        std::size_t coarse = 0;
        for (std::size_t i = 10; i < errors.size(); ++i) {
            coarse += std::abs(errors[i] - errors[i - 10]) > 0.1 * kSample ? 1 : 0;
        }
        CHECK(coarse < errors.size() / 10);
    }
}

TEST_CASE("steady line: it never slides faster than is heard, unless a clock was set") {
    Link link{.jitter = 5e-3};
    link.run(0.0, 1.0);
    const auto errors = link.run(1.0, 30.0);
    for (std::size_t i = 1; i < errors.size(); ++i) {
        CHECK(std::abs(errors[i] - errors[i - 1]) < 1e-2 * 5.1e-4);
    }
    link.step = 3600.0;
    link.run(30.0, 32.0);
    const auto after = link.run(32.0, 40.0);
    CHECK(most(after) < 1e-3);
    link.step = -3600.0;
    const auto back = link.run(40.0, 42.0);
    CHECK(std::abs(back.back()) < 1e-3);
}

TEST_CASE("steady line: there and back is the same time") {
    Link link{.drift = 30e-6, .jitter = 1e-3};
    link.run(0.0, 20.0);
    for (const double x : {0.0, 19.0, 25.0}) {
        CHECK(link.line.to_x(link.line.to_y(x)) == doctest::Approx(x).epsilon(1e-9));
    }
}
