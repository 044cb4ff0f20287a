#include "core/listening/onset.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "core/listening/onset_match.hpp"

using namespace percussionist::listening;

namespace {

constexpr double kRate = 48000.0;
constexpr double kNoise = 1e-5;  ///< that of 16-bit audio
using std::numbers::pi;

struct Struck {
    double time;       ///< [s]
    double amplitude;  ///< of the force
};

/// The forces of mallets on a head for `contact` [s] each, as Hertz has them.
std::vector<double> forces(const std::vector<Struck>& strokes, double contact, double length) {
    std::vector<double> force(static_cast<std::size_t>(length * kRate));
    for (const Struck& s : strokes) {
        for (std::size_t n = 0; n < force.size(); ++n) {
            const double into = static_cast<double>(n) / kRate - s.time;
            if (into > 0.0 && into < contact) {
                force[n] += s.amplitude * std::pow(std::sin(pi * into / contact), 1.5);
            }
        }
    }
    return force;
}

/// A head of 60 partials from 90 Hz to 4 kHz, the lowest ringing on for seconds, in faint noise.
std::vector<double> drum(const std::vector<Struck>& strokes, double contact, double length) {
    const std::vector<double> force = forces(strokes, contact, length);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> out(force.size());
    for (int m = 0; m < 60; ++m) {
        const double frequency = 90.0 * std::pow(44.0, (m + 0.3 * uniform(random)) / 60);
        const double decay = 0.02 + 0.6 * 90.0 / frequency;
        const double r = std::exp(-1.0 / (decay * kRate));
        const double c = 2.0 * r * std::cos(2.0 * pi * frequency / kRate);
        const double weight = 0.2 + uniform(random);
        double y1 = 0.0, y2 = 0.0;
        for (std::size_t n = 0; n < out.size(); ++n) {
            const double y = c * y1 - r * r * y2 + force[n];
            out[n] += weight * (y - y1);
            y2 = y1;
            y1 = y;
        }
    }
    double peak = 0.0;
    for (const double x : out) {
        peak = std::max(peak, std::abs(x));
    }
    std::normal_distribution<double> normal;
    for (double& x : out) {
        x = x / peak + kNoise * normal(random);
    }
    return out;
}

std::vector<double> times_of(const std::vector<Struck>& strokes) {
    std::vector<double> times;
    for (const Struck& s : strokes) {
        times.push_back(s.time);
    }
    return times;
}

std::vector<double> times_of(const std::vector<Onset>& onsets) {
    std::vector<double> times;
    for (const Onset& onset : onsets) {
        times.push_back(onset.time);
    }
    return times;
}

/// Every 60 ms a stroke, the loudness wandering by `range_db` but by 12 dB at most from one to the
/// next.
std::vector<Struck> wandering(int count, double range_db) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> step(-12.0, 12.0);
    std::vector<Struck> strokes;
    double level = 0.0;
    for (int i = 0; i < count; ++i) {
        strokes.push_back({0.1 + 0.060 * i + 1e-5 * (i % 7), std::pow(10.0, level / 20.0)});
        level = std::clamp(level + step(random), -range_db, 0.0);
    }
    return strokes;
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

TEST_CASE("strokes of a soft mallet, 5.5 ms in contact, are found to 0.3 ms") {
    const auto strokes = wandering(60, 6.0);
    const auto signal = drum(strokes, 0.0055, 4.0);
    const auto m = match(times_of(strokes), times_of(find_onsets(signal, kRate)), 0.005);
    CHECK(m.missed.empty());
    CHECK(m.extra.empty());
    CHECK(m.worst_error < 0.0003);
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
