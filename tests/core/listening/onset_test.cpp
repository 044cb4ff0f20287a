#include "core/listening/onset.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/listening/onset_match.hpp"
#include "support/struck_drum.hpp"

using namespace percussionist::listening;
using namespace percussionist::test;

namespace {

std::vector<double> times_of(const std::vector<Onset>& onsets) {
    std::vector<double> times;
    for (const Onset& onset : onsets) {
        times.push_back(onset.time);
    }
    return times;
}

}  // namespace

TEST_CASE("strokes 60 ms apart over 40 dB of loudness are all found, to 0.3 ms") {
    const auto strokes = wandering(60, 40.0);
    const auto signal = drum(strokes, 0.001, 4.0);
    const auto m = match(times_of(strokes), times_of(find_onsets(signal, kRate)), 0.005);
    CHECK(m.missed.empty());
    CHECK(m.extra.empty());
    CHECK(std::abs(m.offset) < 0.0005);
    CHECK(m.median_error < 0.0001);
    CHECK(m.worst_error < 0.0003);
}

TEST_CASE("strokes are found where the mallet arrives, not where it leaves, to 0.1 ms") {
    const auto strokes = wandering(60, 6.0);
    for (const double contact : {0.002, 0.003, 0.0055}) {
        const auto signal = drum(strokes, contact, 4.0);
        const auto m = match(times_of(strokes), times_of(find_onsets(signal, kRate)), 0.005);
        CHECK(m.missed.empty());
        CHECK(m.extra.empty());
        CHECK(std::abs(m.offset) < 0.0001);
        CHECK(m.worst_error < 0.0001);
    }
}

TEST_CASE("a stroke 40 dB above or below the one 60 ms before is found in time") {
    const std::vector<Struck> strokes = {{0.1, 1.0}, {0.5, 0.01}, {0.56, 1.0}, {1.0, 0.01}};
    const auto near = onsets_near(drum(strokes, 0.0005, 1.5), kRate, times_of(strokes), 0.01);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        REQUIRE(near[i].has_value());
        CHECK(std::abs(*near[i] - strokes[i].time) < 0.0005);
    }
    const std::vector<Struck> falling = {{0.1, 1.0}, {0.16, 0.01}};
    const auto after = onsets_near(drum(falling, 0.0005, 0.5), kRate, times_of(falling), 0.01);
    REQUIRE(after[1].has_value());
    CHECK(std::abs(*after[1] - 0.16) < 0.0005);
}

TEST_CASE("who knows when to listen hears more") {
    const auto strokes = wandering(120, 12.0);
    const auto signal = drum(strokes, 0.0055, 8.0);
    const std::size_t blind = find_onsets(signal, kRate).size();
    const auto near = onsets_near(signal, kRate, times_of(strokes), 0.01);
    const auto heard = std::count_if(near.begin(), near.end(), [](auto& n) { return bool(n); });
    CHECK(blind < strokes.size());
    CHECK(heard == static_cast<std::ptrdiff_t>(strokes.size()));
}

TEST_CASE("where nothing is struck nothing is found") {
    const std::vector<Struck> strokes = {{0.1, 1.0}};
    const auto signal = drum(strokes, 0.003, 3.0);
    CHECK(find_onsets(signal, kRate).size() == 1);
    const std::vector<double> times = {0.1, 0.7, 1.5};
    const auto near = onsets_near(signal, kRate, times, 0.02);
    CHECK(near[0].has_value());
    CHECK_FALSE(near[1].has_value());
    CHECK_FALSE(near[2].has_value());
    CHECK(find_onsets(std::vector<double>(48000, 0.0), kRate).empty());
    CHECK(find_onsets({}, kRate).empty());
}

TEST_CASE("louder or earlier as a whole, the signal has the same onsets, earlier") {
    const auto strokes = wandering(12, 20.0);
    const auto signal = drum(strokes, 0.002, 1.0);
    // A whole number of the 2 ms steps in which the search walks.
    constexpr double kEarlier = 0.05;
    std::vector<double> earlier(signal.begin() + static_cast<std::ptrdiff_t>(kEarlier * kRate),
                                signal.end());
    for (double& x : earlier) {
        x *= 8.0;
    }
    const auto found = find_onsets(signal, kRate);
    const auto found_earlier = find_onsets(earlier, kRate);
    REQUIRE(found.size() == strokes.size());
    REQUIRE(found_earlier.size() == strokes.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].time - found_earlier[i].time == doctest::Approx(kEarlier).epsilon(1e-6));
    }
}

TEST_CASE("a rate too low to hear strokes is refused") {
    CHECK_THROWS_AS(find_onsets({}, 8000.0), std::invalid_argument);
    CHECK_THROWS_AS(find_onsets({}, std::nan("")), std::invalid_argument);
}
