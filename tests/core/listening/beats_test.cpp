#include "core/listening/beats.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace percussionist::listening;

namespace {

/// Kick and snare in turn on beats from `first`, hats on eighths; the beat changes by `drift` a
/// beat.
std::vector<DrumStroke> groove(double beat, double first, int beats, int per_bar,
                               double drift = 0.0) {
    std::vector<DrumStroke> strokes;
    double t = first;
    for (int b = 0; b < beats; ++b) {
        const bool back = per_bar == 4 ? b % 2 == 1 : b % 3 != 0;
        strokes.push_back({.time = t, .drum = back ? DrumClass::snare : DrumClass::kick});
        if (b % (4 * per_bar) == 0) strokes.push_back({.time = t, .drum = DrumClass::crash});
        strokes.push_back({.time = t, .drum = DrumClass::closed_hat});
        strokes.push_back({.time = t + 0.5 * beat, .drum = DrumClass::closed_hat, .velocity = 0.6});
        t += beat;
        beat += drift;
    }
    return strokes;
}

}  // namespace

TEST_CASE("the beat of a groove is found, whatever its tempo") {
    for (const double tempo : {80.0, 97.0, 120.0, 140.0}) {
        const double beat = 60.0 / tempo;
        const Beats found = find_beats(groove(beat, 0.3, 48, 4), 48 * beat + 1.0);
        CAPTURE(tempo);
        CHECK(found.seconds_per_beat() == doctest::Approx(beat).epsilon(0.01));
        for (const double t : found.times) {
            const double off = std::remainder(t - 0.3, beat);
            CHECK(std::abs(off) < 0.02);
        }
    }
}

TEST_CASE("bars begin where kick and crash do") {
    const Beats found = find_beats(groove(0.5, 0.3, 64, 4), 33.0);
    CHECK(found.per_bar == 4);
    const double first = found.times[found.first_downbeat];
    CHECK(std::abs(std::remainder(first - 0.3, 2.0)) < 0.03);
}

TEST_CASE("a drummer who hurries is followed") {
    const auto strokes = groove(0.6, 0.2, 80, 4, -0.001);
    const Beats found = find_beats(strokes, strokes.back().time + 1.0);
    std::size_t met = 0;
    for (const double t : found.times) {
        for (const auto& s : strokes) {
            if (s.drum != DrumClass::closed_hat && s.drum != DrumClass::crash &&
                std::abs(s.time - t) < 0.03)
                ++met;
        }
    }
    CHECK(met > 72);
}

TEST_CASE("where nothing is struck there are no beats; one stroke is enough for one") {
    CHECK(find_beats({}, 10.0).times.empty());
    const std::vector<DrumStroke> one = {{.time = 1.0}};
    CHECK(find_beats(one, 2.0).times.size() >= 1);
}
