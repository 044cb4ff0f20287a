#include "core/listening/onset_match.hpp"

#include <doctest/doctest.h>

#include <random>
#include <stdexcept>

using namespace percussionist::listening;

using Times = std::vector<double>;
using Indices = std::vector<std::size_t>;

TEST_CASE("what is constant is the offset, what varies the error") {
    const auto m = match(Times{1, 2, 3, 4, 5}, Times{1.02, 2.02, 3.021, 4.02, 5.017}, 0.05);
    CHECK(m.offset == doctest::Approx(0.02));
    CHECK(m.median_error == doctest::Approx(0.0).scale(1.0));
    CHECK(m.worst_error == doctest::Approx(0.003));
    CHECK(m.missed.empty());
    CHECK(m.extra.empty());
}

TEST_CASE("missed and extra onsets are named") {
    const auto m = match(Times{1, 2, 3}, Times{0.5, 1.0, 3.0, 3.4}, 0.01);
    CHECK(m.pairs.size() == 2);
    CHECK(m.missed == Indices{1});
    CHECK(m.extra == Indices{0, 3});
}

TEST_CASE("a stroke closer to its neighbour's expectation does not take it") {
    // The second was missed; both found ones are a little late.
    const auto m = match(Times{1.000, 1.010, 1.020}, Times{1.004, 1.024}, 0.012);
    REQUIRE(m.pairs.size() == 2);
    CHECK(m.pairs[0].expected == 0);
    CHECK(m.pairs[1].expected == 2);
    CHECK(m.missed == Indices{1});
}

TEST_CASE("of two found for one expected the nearer counts") {
    const auto m = match(Times{1.0, 2.0, 3.0}, Times{1.0, 1.99, 2.001, 3.0}, 0.02);
    CHECK(m.extra == Indices{1});
}

TEST_CASE("every time is in a pair or alone, whatever the lists") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> gap(0.0, 0.1);
    for (int trial = 0; trial < 200; ++trial) {
        Times a, b;
        for (double t = 0; t < 3.0; t += gap(random)) a.push_back(t);
        for (double t = 0; t < 3.0; t += gap(random)) b.push_back(t);
        const auto m = match(a, b, 0.03);
        CHECK(m.pairs.size() + m.missed.size() == a.size());
        CHECK(m.pairs.size() + m.extra.size() == b.size());
        CHECK(m.worst_error <= 0.03);
    }
}

TEST_CASE("nothing matches nothing") {
    const auto m = match({}, {}, 0.01);
    CHECK(m.pairs.empty());
    CHECK(match(Times{1.0}, {}, 0.01).missed == Indices{0});
    CHECK(match({}, Times{1.0}, 0.01).extra == Indices{0});
    CHECK_THROWS_AS(match({}, {}, -1.0), std::invalid_argument);
}
