// A kit for tests: kick, snare, hi-hat, ride and three toms about a right-handed drummer, what its
// objects are made of, and scores and strokes for it.
#pragma once

#include <string>
#include <vector>

#include "core/modal/resonator.hpp"
#include "core/score/kit.hpp"
#include "core/score/kit_plan.hpp"
#include "core/score/score.hpp"

namespace percussionist::test {

enum SmallKitKey {
    kKick = 36,
    kSnare = 38,
    kFloorTom = 43,
    kHat = 42,
    kMidTom = 47,
    kHighTom = 50,
    kRide = 51
};

inline score::Kit small_kit() {
    using score::Limb;
    score::Kit kit;
    kit.name = "small";
    const auto add = [&](const std::string& name, int key, const score::Vector3& middle) {
        score::KitObject object;
        object.name = name;
        object.middle = middle;
        object.radius = 0.15;
        object.sound = "snare";
        kit.objects.push_back(object);
        score::KitEvent event;
        event.name = name;
        event.object = kit.objects.size() - 1;
        event.apart = 0.04;
        kit.keys[key] = static_cast<int>(kit.events.size());
        kit.events.push_back(event);
    };
    add("kick", kKick, {0.72, -0.14, 0.30});
    add("snare", kSnare, {0.50, 0.06, 0.66});
    add("hat", kHat, {0.54, 0.44, 0.86});
    add("ride", kRide, {0.64, -0.68, 0.96});
    add("high-tom", kHighTom, {0.74, 0.13, 0.84});
    add("mid-tom", kMidTom, {0.73, -0.20, 0.83});
    add("floor-tom", kFloorTom, {0.46, -0.54, 0.64});
    kit.events[0].foot = Limb::right_foot;
    kit.events[0].apart = 0.0;
    kit.pedals.push_back({.object = 0, .foot = Limb::right_foot, .heel = {0.35, -0.15, 0.03}});
    kit.events[1].hand = Limb::left_hand;
    kit.events[2].hand = kit.events[3].hand = Limb::right_hand;
    const std::size_t size = kit.events.size();
    kit.pairs.resize(size * size);
    kit.pairs[2 * size + 1] = score::PairPreference{Limb::right_hand, true};
    kit.pairs[1 * size + 2] = score::PairPreference{Limb::left_hand, true};
    return kit;
}

/// A membrane for each object.
inline std::vector<modal::Resonator> small_bodies(const score::Kit& kit) {
    std::vector<modal::Resonator> bodies;
    for (const score::KitObject& object : kit.objects) {
        bodies.emplace_back(modal::Membrane{.radius = object.radius}, modal::Decay{},
                            modal::Choice{.count = 64});
    }
    return bodies;
}

inline score::Note kit_note(double time, int key, double velocity = 0.7) {
    return {time, key, velocity, 9, score::TempoMap().position_at(time)};
}

/// One key after another, evenly; 0 is a rest.
inline score::Score kit_line(const std::vector<int>& keys, double interval) {
    score::Score score;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const double time = interval * static_cast<double>(i);
        if (keys[i] != 0) score.notes.push_back(kit_note(time, keys[i]));
    }
    return score;
}

/// Hat and snare, `apart` seconds each, kick below.
inline std::vector<score::KitStroke> hat_and_snare(const score::Kit& kit, int count,
                                                   double apart = 0.25) {
    using score::Limb;
    std::vector<score::KitStroke> strokes;
    const auto event = [&](const char* name) { return *kit.event_named(name); };
    for (int i = 0; i < count; ++i) {
        const double time = apart * i;
        strokes.push_back({time, Limb::right_hand, event("hat"), 0.6, 0, false, {}});
        if (i % 4 == 2) {
            strokes.push_back({time, Limb::left_hand, event("snare"), 0.9, 0, false, {}});
        }
        if (i % 4 == 0) {
            strokes.push_back({time, Limb::right_foot, event("kick"), 0.8, 0, false, {}});
        }
    }
    return strokes;
}

}  // namespace percussionist::test
