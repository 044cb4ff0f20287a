#include "core/score/tempo_map.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace percussionist::score;

namespace {

void check_position(const Position& position, int bar, double beat) {
    CHECK(position.bar == bar);
    CHECK(position.beat == doctest::Approx(beat).epsilon(1e-9));
}

}  // namespace

TEST_CASE("with nothing said, a score is at 120 quarters a minute and in 4/4") {
    const TempoMap map;
    CHECK(map.seconds(480) == doctest::Approx(0.5));
    check_position(map.position(0), 1, 1);
    check_position(map.position(480 * 5), 2, 2);
}

TEST_CASE("time is the sum of each tempo's share") {
    const TempoMap map({.ticks_per_quarter = 100}, {{0, 1.0}, {200, 0.25}, {300, 2.0}}, {});
    CHECK(map.seconds(100) == doctest::Approx(1.0));
    CHECK(map.seconds(200) == doctest::Approx(2.0));
    CHECK(map.seconds(300) == doctest::Approx(2.25));
    CHECK(map.seconds(350) == doctest::Approx(3.25));
}

TEST_CASE("tempo changes do not move bars, wherever in the list they stand") {
    const TempoMap map({.ticks_per_quarter = 100}, {{300, 2.0}, {200, 0.25}, {0, 1.0}}, {});
    check_position(map.position(450), 2, 1.5);
    CHECK(map.seconds(300) == doctest::Approx(2.25));
}

TEST_CASE("of two tempi at one tick the last one given holds") {
    const TempoMap map({.ticks_per_quarter = 100}, {{0, 1.0}, {0, 0.5}}, {});
    CHECK(map.seconds(100) == doctest::Approx(0.5));
}

TEST_CASE("a beat is the lower number of the time signature, and a new signature a new bar") {
    // A bar of 4/4, a bar and a half of 6/8 cut off by 3/4.
    const TempoMap map({.ticks_per_quarter = 100}, {}, {{0, 4, 4}, {400, 6, 8}, {850, 3, 4}});
    check_position(map.position(399), 1, 4.99);
    check_position(map.position(400), 2, 1);
    check_position(map.position(450), 2, 2);
    check_position(map.position(700), 3, 1);
    check_position(map.position(850), 4, 1);
    check_position(map.position(1150), 5, 1);
}

TEST_CASE("SMPTE ticks are seconds whatever the tempo, which counts bars alone") {
    const TempoMap map({.ticks_per_second = 1000}, {{0, 0.25}}, {});
    CHECK(map.seconds(1500) == doctest::Approx(1.5));
    check_position(map.position(1500), 2, 3);
}

TEST_CASE("the place of an instant is the place of its tick") {
    const TempoMap map({.ticks_per_quarter = 96}, {{0, 0.6}, {500, 0.31}, {777, 1.7}},
                       {{0, 3, 4}, {288, 7, 8}});
    for (Tick tick = 0; tick < 3000; tick += 7) {
        const Position by_tick = map.position(tick);
        const Position by_time = map.position_at(map.seconds(tick));
        CHECK(by_time.bar == by_tick.bar);
        CHECK(by_time.beat == doctest::Approx(by_tick.beat).epsilon(1e-6));
    }
}

TEST_CASE("rounding does not put a downbeat at the end of the bar before") {
    const TempoMap map({.ticks_per_quarter = 480}, {{0, 0.3333333}, {7, 0.1234567}}, {{0, 3, 4}});
    for (int bar = 0; bar < 2000; ++bar) {
        const Position position = map.position_at(map.seconds(static_cast<Tick>(bar) * 1440));
        CHECK(position.bar == bar + 1);
        CHECK(position.beat == 1.0);
    }
}

TEST_CASE("a division, a tempo or a metre that cannot be is refused") {
    CHECK_THROWS_AS(TempoMap({.ticks_per_quarter = 0}, {}, {}), std::invalid_argument);
    CHECK_THROWS_AS(TempoMap({.ticks_per_second = -1}, {}, {}), std::invalid_argument);
    CHECK_THROWS_AS(TempoMap({}, {{0, 0.0}}, {}), std::invalid_argument);
    CHECK_THROWS_AS(TempoMap({}, {}, {{0, 0, 4}}), std::invalid_argument);
}
