#include "io/playout.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace percussionist::io;

namespace {

constexpr double kTick = 64.0 / 48000;
constexpr double kSample = 1.0 / 48000;

std::unique_ptr<Delivery> delivery(std::optional<double> due, std::uint64_t serial) {
    auto d = std::make_unique<Delivery>();
    d->due = due;
    d->serial = serial;
    return d;
}

/// A Pd whose audio device wants blocks, drops out, and whose thread wakes late.
struct FakePd {
    Playout playout{1000};
    double logical = 0.0;
    double monotonic = 7e4;  // when the device wants its next block
    double block = kTick;
    double lateness = 0.0;
    std::mt19937_64 random{1};
    std::vector<std::pair<std::uint64_t, double>> played = {};

    void run(double seconds) {
        std::uniform_real_distribution<double> late(0.0, lateness + 1e-12);
        for (const double end = monotonic + seconds; monotonic < end; monotonic += block) {
            const double woken = monotonic + late(random);
            for (double done = 0.0; done < block - 1e-9; done += kTick) {
                playout.tick(logical, woken);
                play_to(logical);
                while (playout.next() < logical + kTick) {
                    play_to(std::max(playout.next(), logical));
                }
                logical += kTick;
            }
        }
    }
    void play_to(double time) {
        while (auto d = playout.take(time)) {
            played.emplace_back(d->serial, time);
        }
    }
};

}  // namespace

TEST_CASE("deliveries leave at their time by the logical clock, those of one time in order") {
    FakePd pd;
    pd.run(1.0);
    const double now = pd.monotonic;
    for (const int i : {5, 3, 0, 4, 1, 2}) {
        pd.playout.add(delivery(now + 0.01 * (i / 2) + 1e-4, static_cast<std::uint64_t>(i)));
    }
    const double logical = pd.logical;
    pd.run(1.0);
    REQUIRE(pd.played.size() == 6);
    for (int i = 0; i < 6; ++i) {
        CHECK(pd.played[i].first == static_cast<std::uint64_t>(i));
        CHECK(pd.played[i].second ==
              doctest::Approx(logical + 0.01 * (i / 2) + 1e-4).epsilon(1e-9));
    }
    CHECK(pd.playout.late() == 0);
}

TEST_CASE("what is due at once leaves at once, before what waits, in its order") {
    FakePd pd;
    pd.run(0.5);
    pd.playout.add(delivery(pd.monotonic + 0.01, 0));
    pd.playout.add(delivery({}, 1));
    pd.playout.add(delivery({}, 2));
    pd.play_to(pd.logical);
    REQUIRE(pd.played.size() == 2);
    CHECK(pd.played[0].first == 1);
    CHECK(pd.played[1].first == 2);
    CHECK(pd.playout.late() == 0);
}

TEST_CASE("what is late leaves at once and is counted") {
    FakePd pd;
    pd.run(0.5);
    pd.playout.add(delivery(pd.monotonic - 0.02, 0));
    pd.run(0.1);
    REQUIRE(pd.played.size() == 1);
    CHECK(pd.playout.late() == 1);
    CHECK(pd.playout.latest() == doctest::Approx(0.02).epsilon(0.1));
}

TEST_CASE("what is stale is counted, and comes without its messages; with latency it is in time") {
    for (const double latency : {0.0, 0.2}) {
        FakePd pd;
        pd.run(0.5);
        pd.playout.set_latency(latency);
        auto stale = delivery(pd.monotonic - 0.15, 0);
        stale->stale = true;
        stale->messages.emplace_back();
        pd.playout.add(std::move(stale));
        const auto taken = pd.playout.take(std::max(pd.logical, pd.playout.next()));
        REQUIRE(taken);
        CHECK(taken->messages.empty() == (latency == 0.0));
        CHECK(pd.playout.late() == (latency == 0.0 ? 1 : 0));
    }
}

TEST_CASE("latency is added to what has a time") {
    FakePd pd;
    pd.run(0.5);
    pd.playout.set_latency(0.05);
    pd.playout.add(delivery(pd.monotonic, 0));
    const double logical = pd.logical;
    pd.run(0.2);
    REQUIRE(pd.played.size() == 1);
    CHECK(pd.played[0].second == doctest::Approx(logical + 0.05).epsilon(1e-6));
}

TEST_CASE("blocks of any size, woken late: events stay even to a fraction of a sample") {
    for (const double block : {kTick, 4 * kTick, 16 * kTick}) {
        CAPTURE(block);
        FakePd pd{.block = block, .lateness = 6e-4};
        pd.run(5.0);
        std::uint64_t serial = 0;
        std::vector<double> due;
        for (int i = 0; i < 200; ++i) {
            due.push_back(pd.monotonic + 0.03 + 1e-4 * i);
            pd.playout.add(delivery(due.back(), serial++));
            pd.run(0.05);
        }
        pd.run(0.1);
        REQUIRE(pd.played.size() == 200);
        double sum = 0.0, squares = 0.0;
        for (const auto& [number, time] : pd.played) {
            const double error = time - due[number] + 7e4;
            sum += error;
            squares += error * error;
        }
        const double variance = squares / 200 - sum / 200 * (sum / 200);
        CHECK(variance < 0.25 * kSample * kSample);
        CHECK(pd.playout.late() == 0);
    }
}

TEST_CASE("after a drop-out of the device events are in place again within a second") {
    FakePd pd{.block = 4 * kTick, .lateness = 3e-4};
    pd.run(5.0);
    double gap = 0.0;
    for (int i = 0; i < 20; ++i) {
        const double drop = 0.003 + 0.01 * i;
        pd.monotonic += drop;  // the device stands still; logical time does too
        gap += drop;
        pd.run(0.9);
        pd.played.clear();
        const double due = pd.monotonic + 0.03;
        pd.playout.add(delivery(due, 0));
        pd.run(0.1);
        REQUIRE(pd.played.size() == 1);
        CHECK(std::abs(pd.played[0].second - (due - 7e4 - gap)) < 4 * kTick);
    }
}

TEST_CASE("a Pd that was stopped and catches up loses its place not at all") {
    FakePd pd{.lateness = 3e-4};
    pd.run(5.0);
    const double offset = pd.monotonic - pd.logical;
    pd.playout.add(delivery(pd.monotonic + 0.25, 0));
    pd.monotonic += 0.5;
    while (pd.logical < pd.monotonic - offset) {
        pd.playout.tick(pd.logical, pd.monotonic);
        while (pd.playout.next() < pd.logical + kTick) {
            pd.play_to(pd.playout.next());
        }
        pd.logical += kTick;
    }
    pd.playout.add(delivery(pd.monotonic + 0.25, 1));
    const double due = pd.monotonic + 0.25;
    const double caught_up = pd.monotonic - pd.logical;
    pd.run(0.5);
    REQUIRE(pd.played.size() == 2);
    CHECK(pd.played[0].second == doctest::Approx(due - 0.5 - offset).epsilon(1e-5));
    CHECK(pd.played[1].second == doctest::Approx(due - caught_up).epsilon(1e-5));
    CHECK(pd.playout.late() == 0);
}
