#include "sim/simulated_drummer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/score/stroke_plan.hpp"
#include "support/small_kit.hpp"

using namespace percussionist;
using body::KitContact;
using score::Limb;
using sim::SimulatedDrummer;
using test::hat_and_snare;

namespace {

/// A drummer's body, what leads it, a song and its clock, stepped together.
struct Playing {
    body::LiveDrummer led{test::small_kit()};
    SimulatedDrummer drummer{led, test::small_bodies(led.kit())};
    score::SongClock clock;
    std::vector<KitContact> contacts;
    long steps = 0;

    double now() const { return static_cast<double>(steps) * SimulatedDrummer::kStep; }
    void run(double seconds) {
        for (const double end = now() + seconds; now() < end;) {
            ++steps;
            drummer.step(now(), clock.advance(now()));
            const auto& made = drummer.contacts();
            contacts.insert(contacts.end(), made.begin(), made.end());
        }
    }
    std::vector<KitContact> of_strokes() const {
        std::vector<KitContact> own;
        std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(own),
                     [](const KitContact& c) { return c.stroke >= 0; });
        return own;
    }
    std::size_t event(const char* name) const { return *led.kit().event_named(name); }
};

}  // namespace

TEST_CASE("simulated drummer: each stroke of a song is one contact of his body, within 5 ms") {
    Playing p;
    const auto strokes = hat_and_snare(p.led.kit(), 16);
    p.drummer.load(strokes);
    p.clock.play(p.now(), -1.0);
    p.run(5.5);
    const auto own = p.of_strokes();
    REQUIRE(own.size() == strokes.size());
    std::vector<int> times(strokes.size(), 0);
    for (const KitContact& c : own) {
        const score::KitStroke& stroke = strokes[static_cast<std::size_t>(c.stroke)];
        CAPTURE(stroke.time);
        ++times[static_cast<std::size_t>(c.stroke)];
        CHECK(c.limb == stroke.limb);
        CHECK(c.event == stroke.event);
        CHECK(std::abs(c.time - (stroke.time + 1.0)) < 1e-6);
        REQUIRE(c.touch);
        CHECK(std::abs(c.touch->instant - c.time) < 0.005);
        CHECK(c.touch->velocity.z() < 0.0);
        CHECK(c.touch->impulse > 0.0);
    }
    CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    CHECK(p.drummer.passed_over() == 0);
}

TEST_CASE(
    "simulated drummer: a louder stroke is harder, a contact is told soon after its instant") {
    Playing p;
    std::vector<score::KitStroke> strokes;
    for (int i = 0; i < 8; ++i) {
        strokes.push_back(
            {0.4 * i, Limb::left_hand, p.event("snare"), i % 2 == 0 ? 0.3 : 0.9, 0, false, {}});
    }
    p.drummer.load(strokes);
    p.clock.play(p.now(), -1.0);
    double soft = 0.0, loud = 1e9;
    while (p.now() < 4.5) {
        p.run(SimulatedDrummer::kStep);
        for (const KitContact& c : p.drummer.contacts()) {
            CHECK(p.now() - c.touch->instant < 0.025);
            if (c.stroke < 0) continue;
            double& edge = c.stroke % 2 == 0 ? soft : loud;
            edge = c.stroke % 2 == 0 ? std::max(soft, c.touch->impulse)
                                     : std::min(loud, c.touch->impulse);
        }
    }
    CHECK(soft > 0.0);
    CHECK(loud > 1.5 * soft);
}

TEST_CASE("simulated drummer: a live note is struck by his body, and is told who sounded it") {
    for (const bool sounded : {false, true}) {
        Playing p;
        p.run(0.5);
        const body::LiveStroke answer = p.drummer.strike(p.event("snare"), 0.7, sounded);
        REQUIRE(answer.limb);
        p.run(0.6);
        const auto made = std::find_if(p.contacts.begin(), p.contacts.end(),
                                       [&](const KitContact& c) { return c.limb == *answer.limb; });
        REQUIRE(made != p.contacts.end());
        CHECK(made->event == p.event("snare"));
        CHECK(made->sounded == sounded);
        CHECK(std::abs(made->touch->instant - answer.time) < 0.01);
    }
}

TEST_CASE("simulated drummer: after a jump he plays on, from where the song is") {
    Playing p;
    const auto strokes = hat_and_snare(p.led.kit(), 40);
    p.drummer.load(strokes);
    p.clock.play(p.now(), -1.0);
    p.run(2.5);
    p.contacts.clear();
    p.clock.play(p.now(), 5.9);
    p.run(3.0);
    const int first =
        3 + static_cast<int>(std::count_if(strokes.begin(), strokes.end(),
                                           [](const score::KitStroke& s) { return s.time < 6.5; }));
    const auto own = p.of_strokes();
    const auto later = std::count_if(own.begin(), own.end(),
                                     [&](const KitContact& c) { return c.stroke >= first; });
    const auto due = std::count_if(strokes.begin() + first, strokes.end(),
                                   [](const score::KitStroke& s) { return s.time < 8.85; });
    CHECK(later == due);
    CHECK(due > 8);
}
