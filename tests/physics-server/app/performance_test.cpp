#include "app/performance.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/drum_sound.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

namespace {

/// Plays to the end.
void play(app::Performance& performance, std::vector<score::Stroke> strokes) {
    performance.load(std::move(strokes));
    performance.play();
    while (performance.playing()) performance.step();
}

std::vector<score::Stroke> strokes_of(const std::vector<double>& speeds, double interval) {
    std::vector<score::Stroke> strokes;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        score::Stroke s;
        s.time = interval * static_cast<double>(i);
        s.hand = static_cast<int>(i % 2);
        s.speed = speeds[i];
        s.height = score::preparation_height(s.speed);
        strokes.push_back(s);
    }
    return strokes;
}

}  // namespace

TEST_CASE("performance: every stroke of the built-in piece is one contact, in time") {
    app::Performance performance({});
    auto strokes = app::load_score({}).strokes;
    const auto count = static_cast<int>(strokes.size());
    play(performance, std::move(strokes));
    const app::TimingSummary s = performance.summary();
    CHECK(s.strokes == count);
    CHECK(s.contacts == count);
    CHECK(s.uncalled == 0);
    CHECK(s.worst_error < 0.003);
}

TEST_CASE("performance: real drummers' strokes are one contact each, in time") {
    for (const auto& file : test::real_files("midi", ".mid")) {
        if (!file.filename().string().starts_with("drummer")) continue;
        CAPTURE(file.filename().string());
        app::Performance performance({});
        play(performance, app::load_score(file).strokes);
        const app::TimingSummary s = performance.summary();
        CHECK(s.contacts == s.strokes);
        CHECK(s.uncalled == 0);
        CHECK(s.worst_error < 0.003);
    }
}

TEST_CASE("performance: what is louder in the score is louder as force and as sound") {
    std::vector<double> speeds;
    for (const double velocity : {0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0}) {
        speeds.push_back(score::impact_speed(velocity));
    }
    app::Performance performance({});
    play(performance, strokes_of(speeds, 2.0));
    const auto& contacts = performance.log().contacts();
    REQUIRE(contacts.size() == speeds.size());
    const files::Audio sound =
        app::drum_sound(performance.log(), performance.simulation().time(), 48000, {});
    double last_force = 0.0;
    double last_peak = 0.0;
    for (const app::LoggedContact& c : contacts) {
        const auto from = static_cast<std::ptrdiff_t>(48000 * c.event.instant);
        double peak = 0.0;
        for (std::ptrdiff_t i = from; i < from + 4800; ++i) {
            peak = std::max(peak, std::abs(sound.samples[static_cast<std::size_t>(i)]));
        }
        CHECK(-c.event.peak_force.z() > last_force);
        CHECK(peak > last_peak);
        last_force = -c.event.peak_force.z();
        last_peak = peak;
    }
}

TEST_CASE("performance: a change of tempo moves the strokes to come, and loses none") {
    app::Performance performance({});
    performance.load(strokes_of(std::vector<double>(12, 2.0), 0.5));
    performance.play();
    while (performance.simulation().time() < 2.2) performance.step();
    performance.player().set_tempo(1.5);
    while (performance.playing()) performance.step();
    const app::TimingSummary s = performance.summary();
    CHECK(s.contacts == 12);
    CHECK(s.uncalled == 0);
    const auto& contacts = performance.log().contacts();
    const double last = contacts[11].event.instant - contacts[10].event.instant;
    CHECK(last == doctest::Approx(0.5 / 1.5).epsilon(0.01));
}

TEST_CASE("performance: stopped, it plays no more; played again, it begins anew") {
    app::Performance performance({});
    performance.load(strokes_of(std::vector<double>(8, 2.0), 0.4));
    performance.play();
    while (performance.simulation().time() < 2.0) performance.step();
    performance.stop();
    const std::size_t before = performance.log().contacts().size();
    while (performance.simulation().time() < 4.0) performance.step();
    CHECK(performance.log().contacts().size() == before);
    performance.play();
    while (performance.playing()) performance.step();
    CHECK(performance.summary().contacts == 8);
    CHECK(performance.summary().missed == 0);
}

TEST_CASE("performance: flams and a fast roll of both hands come out stroke by stroke") {
    std::vector<score::Stroke> strokes = strokes_of(std::vector<double>(32, 1.6), 0.055);
    score::Stroke grace = strokes.back();
    grace.time += 1.0;
    grace.hand = 0;
    grace.speed = 1.0;
    score::Stroke main = grace;
    main.time += 0.025;
    main.hand = 1;
    main.speed = 3.0;
    strokes.push_back(grace);
    strokes.push_back(main);
    app::Performance performance({});
    play(performance, strokes);
    const app::TimingSummary s = performance.summary();
    CHECK(s.contacts == 34);
    CHECK(s.uncalled == 0);
    CHECK(s.worst_error < 0.003);
}
