#include "core/score/song_clock.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace percussionist;
using score::SongClock;

namespace {

constexpr double kStep = 0.001;

/// A player whose clock runs `rate` times as fast, told of `every` so many seconds, each time at an
/// instant known to within `jitter`; the worst error from `settled` on.
double worst_error(double rate, double every, double jitter, double settled, double length) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> off(-jitter, jitter);
    SongClock clock;
    double worst = 0.0, next = 0.0;
    for (int i = 1; i * kStep < length; ++i) {
        const double now = i * kStep;
        if (now >= next) {
            clock.told(now, now + off(random), rate * now);
            next += every;
        }
        clock.advance(now);
        if (now > settled) worst = std::max(worst, std::abs(clock.position() - rate * now));
    }
    return worst;
}

}  // namespace

TEST_CASE("song clock: a player whose clock drifts by 0.1 % is followed at any rate of telling") {
    for (const double rate : {0.999, 1.001}) {
        for (const double every : {0.01, 0.1, 0.5, 1.0, 2.0}) {
            CAPTURE(rate);
            CAPTURE(every);
            // Never more than it drifts in between, and in the filter's memory, of a second.
            CHECK(worst_error(rate, every, 0.0, 0.0, 30.0) < 0.001 * (1.2 * every + 1.0));
            CHECK(worst_error(rate, every, 0.0, 20.0, 60.0) < 2e-4);
        }
    }
}

TEST_CASE("song clock: of instants known to 5 ms only, a small part remains") {
    CHECK(worst_error(1.0, 0.02, 0.005, 3.0, 20.0) < 0.0025);
    CHECK(worst_error(1.001, 0.1, 0.005, 5.0, 20.0) < 0.005);
}

TEST_CASE("song clock: a player that is 3 % fast is followed, and so is one that is a tenth slow") {
    CHECK(worst_error(1.03, 0.1, 0.0, 6.0, 20.0) < 0.001);
    CHECK(worst_error(0.9, 0.1, 0.0, 10.0, 20.0) < 0.001);
}

TEST_CASE("song clock: without a jump it never goes back, nor more than a fifth faster or slower") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> off(-0.03, 0.03);
    SongClock clock;
    clock.told(0.0, 0.0, 5.0);
    clock.advance(kStep);
    for (int i = 2; i < 20000; ++i) {
        const double now = i * kStep;
        if (i % 100 == 0) clock.told(now, now, 5.0 + now + off(random));
        const score::SongStep step = clock.advance(now);
        REQUIRE_FALSE(step.jumped);
        REQUIRE(step.to - step.from >= 0.79 * step.rate * kStep);
        REQUIRE(step.to - step.from <= 1.21 * step.rate * kStep);
    }
}

TEST_CASE("song clock: a seek is one jump, to there and nowhere between; then it goes on") {
    for (const double to : {40.0, 0.5}) {
        SongClock clock;
        clock.told(0.0, 0.0, 10.0);
        int jumps = 0;
        for (int i = 1; i <= 4000; ++i) {
            const double now = i * kStep;
            const double moved = i > 2000 ? to - 12.0 : 0.0;
            if (i % 50 == 1) clock.told(now, now, 10.0 + now + moved);
            const score::SongStep step = clock.advance(now);
            if (step.jumped && i > 1) ++jumps;
            if (i > 2050)
                REQUIRE(clock.position() == doctest::Approx(now + to - 2.0).epsilon(1e-6));
        }
        CHECK(jumps == 1);
    }
}

TEST_CASE("song clock: a pause holds; told of again it goes on from there without a jump") {
    SongClock clock;
    clock.told(0.0, 0.0, 3.0);
    clock.advance(kStep);
    for (int i = 2; i <= 1000; ++i) clock.advance(i * kStep);
    clock.hold(std::nullopt);
    for (int i = 1001; i <= 3000; ++i) {
        const score::SongStep step = clock.advance(i * kStep);
        REQUIRE(step.to == step.from);
        REQUIRE(step.rate == 0.0);
    }
    const double held = clock.position();
    clock.told(3.0, 3.0, held + 0.01);
    bool jumped = false;
    for (int i = 3001; i <= 4000; ++i) jumped = clock.advance(i * kStep).jumped || jumped;
    CHECK_FALSE(jumped);
    CHECK(clock.position() == doctest::Approx(held + 0.01 + 1.0).epsilon(1e-6));
    clock.hold(20.0);
    CHECK(clock.advance(4.001).jumped);
    CHECK(clock.position() == 20.0);
}

TEST_CASE("song clock: by itself it goes at its tempo, from where it is told to begin") {
    SongClock clock;
    clock.tempo().glide(0.0, 2.0, 0.0);
    clock.play(5.0, -1.0);
    clock.advance(5.0);
    CHECK(clock.advance(5.5).to == doctest::Approx(0.0));
    CHECK(clock.advance(8.0).to == doctest::Approx(5.0));
}
