#include "sim/kit_simulation.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "body/kit_animation.hpp"
#include "core/score/kit_plan.hpp"
#include "support/small_kit.hpp"

using namespace percussionist;
using namespace percussionist::test;

namespace {

std::vector<sim::KitContact> play(const score::Kit& kit,
                                  const std::vector<score::KitStroke>& strokes) {
    constexpr double kStart = -1.2;
    const body::KitAnimation animation(kit, strokes);
    body::Posture posture(animation.skeleton());
    body::Placement placement(animation.skeleton());
    animation.at(kStart, posture, placement);
    sim::KitSimulation simulation(kit, small_bodies(kit), posture, kStart);
    std::vector<sim::KitContact> contacts;
    while (simulation.time() < strokes.back().time + 0.3) {
        body::LimbForecasts forecasts;
        for (const score::KitStroke& s : strokes) {
            body::LimbForecast& f = forecasts[score::index(s.limb)];
            if (s.time <= simulation.time()) f.last = {s.time, s.event};
            if (s.time > simulation.time() && s.time < f.next.time) f.next = {s.time, s.event};
        }
        animation.at(simulation.time() + simulation.step_length(), posture, placement);
        simulation.step(posture, forecasts, contacts);
    }
    return contacts;
}

std::vector<score::KitStroke> short_song() {
    score::Score song = kit_line({kSnare, kHighTom, kMidTom, kSnare, kFloorTom, kSnare}, 0.25);
    for (int beat = 0; beat < 3; ++beat) song.notes.push_back(kit_note(0.5 * beat, kKick, 0.6));
    return plan_kit(song, small_kit()).strokes;
}

}  // namespace

TEST_CASE("a simulated drummer strikes each object within 5 ms of its time, feet by their pedals") {
    const score::Kit kit = small_kit();
    const std::vector<score::KitStroke> strokes = short_song();
    const auto contacts = play(kit, strokes);
    for (const score::KitStroke& s : strokes) {
        CAPTURE(kit.events[s.event].name);
        CAPTURE(s.time);
        double off = 1e9;
        for (const sim::KitContact& c : contacts) {
            if (c.limb != s.limb || c.object != kit.events[s.event].object) continue;
            off = std::min(off, std::abs(c.contact.instant - s.time));
        }
        CHECK(off < 0.005);
    }
}

TEST_CASE("the same strokes give the same contacts, to the last bit") {
    const score::Kit kit = small_kit();
    const auto strokes = short_song();
    const auto first = play(kit, strokes);
    const auto second = play(kit, strokes);
    REQUIRE(first.size() == second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].contact.instant == second[i].contact.instant);
        CHECK(first[i].contact.impulse == second[i].contact.impulse);
    }
}
