#include "core/listening/band_analyser.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/listening/practice/dice.hpp"

using namespace percussionist::listening;

namespace {

template <class Signal>
BandFrame frame_of(double rate, Signal signal) {
    BandAnalyser analyser(rate);
    BandFrame frame;
    std::vector<double> block(analyser.hop());
    std::size_t n = 0;
    for (int f = 0; f < 20; ++f) {
        for (double& x : block) x = signal(static_cast<double>(n++) / rate);
        analyser.process(block, frame);
    }
    return frame;
}

double sine(double hz, double t) {
    return std::sin(2.0 * std::numbers::pi * hz * t);
}

}  // namespace

TEST_CASE("a tone is loudest in the band that holds its frequency, at any rate") {
    for (const double rate : {44100.0, 48000.0, 96000.0}) {
        for (const std::size_t band : {10U, 15U, 22U, 30U}) {
            const double hz = level_frequency(band);
            const BandFrame frame = frame_of(rate, [&](double t) { return sine(hz, t); });
            const auto loudest = std::max_element(frame.level.begin(), frame.level.end());
            CHECK(loudest - frame.level.begin() == static_cast<std::ptrdiff_t>(band));
        }
    }
}

TEST_CASE("twice the amplitude is ln 4 more in every band") {
    const auto chord = [](double t) { return sine(200.0, t) + sine(3000.0, t); };
    const BandFrame once = frame_of(48000.0, chord);
    const BandFrame twice = frame_of(48000.0, [&](double t) { return 2.0 * chord(t); });
    for (std::size_t b = 0; b < kLevels; ++b) {
        if (once.level[b] > -20.0F)
            CHECK(twice.level[b] - once.level[b] == doctest::Approx(std::log(4.0)).epsilon(0.01));
    }
}

TEST_CASE("partials raise a band's level far above its floor, noise hardly does") {
    const std::size_t band = 27;
    const double hz = level_frequency(band);
    const BandFrame tone = frame_of(44100.0, [&](double t) { return sine(hz, t); });
    practice::Dice dice(1);
    const BandFrame noise = frame_of(44100.0, [&](double) { return dice.uniform(-1.0, 1.0); });
    const auto gap = [&](const BandFrame& f) {
        return f.level[band] - f.floor[band - (kLevels - kFloors)];
    };
    CHECK(gap(tone) > 4.0F);
    CHECK(gap(noise) < 1.5F);
}

TEST_CASE("rates that cannot be heard at are refused") {
    CHECK_THROWS_AS(BandAnalyser(4000.0), std::invalid_argument);
    CHECK_THROWS_AS(BandAnalyser(NAN), std::invalid_argument);
    CHECK_NOTHROW(BandAnalyser(8000.0));
    CHECK_NOTHROW(BandAnalyser(192000.0));
}
