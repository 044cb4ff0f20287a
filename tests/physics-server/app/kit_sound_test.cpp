#include "app/kit_sound.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/kit_file.hpp"

using namespace percussionist;

namespace {

score::KitStroke stroke(const score::Kit& kit, double time, const char* event, double velocity,
                        score::Limb limb = score::Limb::right_hand) {
    return {time, limb, *kit.event_named(event), velocity, 0};
}

/// The largest of both channels from one time to another [s].
double peak(const files::Audio& audio, double from, double to) {
    double most = 0.0;
    const auto end = static_cast<std::size_t>(2 * to * audio.rate);
    for (auto i = static_cast<std::size_t>(2 * from * audio.rate); i < end; ++i) {
        most = std::max(most, std::abs(audio.samples[i]));
    }
    return most;
}

files::Audio sound(const score::Kit& kit, const std::vector<score::KitStroke>& strokes) {
    return app::kit_sound(kit, strokes, {.rate = 16000, .duration = 2.0, .folder = {}});
}

}  // namespace

TEST_CASE("kit sound: silent before a stroke, louder for a louder one") {
    const score::Kit kit = files::standard_kit();
    for (const char* event : {"snare", "high-tom", "closed-hat", "crash"}) {
        CAPTURE(event);
        const auto soft = sound(kit, {stroke(kit, 0.5, event, 0.3)});
        const auto loud = sound(kit, {stroke(kit, 0.5, event, 0.9)});
        CHECK(peak(soft, 0.0, 0.499) == 0.0);
        CHECK(peak(soft, 0.5, 1.0) > 0.005);
        CHECK(peak(loud, 0.5, 1.0) > 1.5 * peak(soft, 0.5, 1.0));
    }
}

TEST_CASE("kit sound: a closed hi-hat dies where an open one rings, and closing ends it") {
    const score::Kit kit = files::standard_kit();
    const auto open = sound(kit, {stroke(kit, 0.1, "open-hat", 0.8)});
    const auto closed = sound(kit, {stroke(kit, 0.1, "closed-hat", 0.8)});
    const auto shut = sound(kit, {stroke(kit, 0.1, "open-hat", 0.8),
                                  stroke(kit, 0.4, "pedal-hat", 0.5, score::Limb::left_foot)});
    CHECK(peak(closed, 0.6, 1.0) < 0.1 * peak(open, 0.6, 1.0));
    CHECK(peak(shut, 0.8, 1.2) < 0.1 * peak(open, 0.8, 1.2));
}

TEST_CASE("kit sound: what stands to the left is heard to the left") {
    const score::Kit kit = files::standard_kit();
    const auto audio = sound(kit, {stroke(kit, 0.1, "ride", 0.8)});
    double left = 0.0, right = 0.0;
    for (std::size_t i = 0; i < audio.samples.size(); i += 2) {
        left += audio.samples[i] * audio.samples[i];
        right += audio.samples[i + 1] * audio.samples[i + 1];
    }
    CHECK(right > 2.0 * left);
}

TEST_CASE("kit sound: a sound that is none is told with the object it is of") {
    score::Kit kit = files::standard_kit();
    kit.objects[0].sound = "gong";
    try {
        sound(kit, {stroke(kit, 0.1, "snare", 0.8)});
        FAIL("expected an error");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("the sound of snare: no drum 'gong'") == 0);
    }
}
