#include "files/kit_file.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/score/kit_plan.hpp"
#include "files/midi_file.hpp"
#include "support/real_data.hpp"

using namespace percussionist;
using namespace percussionist::files;

namespace {

const std::string kHead = "percussionist kit 1\n";
const std::string kSmall = kHead +
                           "object drum drum at 0.5 0 0.7 tilt 10 0 radius 0.18 sound snare\n"
                           "event hit on drum spot 0 0.05 apart 0.04\n"
                           "key 38 hit\n";

std::string error_of(const std::string& text) {
    try {
        parse_kit(text, "my.kit");
    } catch (const KitError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("kit file: the standard kit plays every percussion sound of General MIDI but whistles") {
    const score::Kit kit = standard_kit();
    for (int key = 35; key <= 81; ++key) {
        const bool whistle = key == 71 || key == 72;
        CHECK((kit.keys[key] == score::kNotOfTheKit) == whistle);
    }
    CHECK(kit.pedals.size() == 2);
    CHECK(kit.pedal_of(score::Limb::right_foot)->object == *kit.object_named("bass"));
}

TEST_CASE("kit file: what is written is what is meant") {
    const score::Kit kit =
        parse_kit(kSmall +
                      "event edge on drum elasticity 0.25 t60 0.5 prefers left # a remark\n"
                      "pair hit edge right crossed\nscript wrist down 0 0.25 1\n"
                      "pose right-hand hit up elbow 10 -20 5\n",
                  "my.kit");
    CHECK(kit.objects[0].normal().x() == doctest::Approx(-std::sin(std::numbers::pi / 18.0)));
    CHECK(kit.events[1].hand == score::Limb::left_hand);
    CHECK(kit.events[1].elasticity == 0.25);
    REQUIRE(kit.pair(0, 1));
    CHECK(kit.pair(0, 1)->hand == score::Limb::right_hand);
    CHECK(kit.pair(1, 0)->hand == score::Limb::left_hand);
    CHECK(kit.pair(1, 0)->may_cross);
    CHECK(kit.scripts[0].curve == std::vector<double>{0.0, 0.25, 1.0});
    REQUIRE(kit.poses.size() == 1);
    CHECK(pose_lines(kit, kit.poses) == "pose right-hand hit up elbow 10.00 -20.00 5.00\n");
}

TEST_CASE("kit file: in a pair an object stands for all that hands play on it") {
    const score::Kit kit = standard_kit();
    for (const char* hat : {"closed-hat", "open-hat"}) {
        for (const char* snare : {"snare", "side-stick"}) {
            const auto& pair = kit.pair(*kit.event_named(hat), *kit.event_named(snare));
            REQUIRE(pair);
            CHECK(pair->hand == score::Limb::right_hand);
            CHECK(pair->may_cross);
        }
    }
    CHECK_FALSE(kit.pair(*kit.event_named("pedal-hat"), *kit.event_named("snare")));
}

TEST_CASE("kit file: spots lie on the face, the left hand's to the left") {
    const score::Kit kit = parse_kit(kSmall, "my.kit");
    const auto left = spot_of(kit, 0, score::Limb::left_hand);
    const auto right = spot_of(kit, 0, score::Limb::right_hand);
    CHECK(left.y() - right.y() == doctest::Approx(0.04));
    CHECK((left - kit.objects[0].middle).dot(kit.objects[0].normal()) == doctest::Approx(0.0));
}

TEST_CASE("kit file: an error names file, line and what was expected") {
    const std::vector<std::pair<std::string, std::string>> faults{
        {"", "line 0: expected 'percussionist kit 1'"},
        {"percussionist kit 2\n", "line 1: expected 'percussionist kit 1'"},
        {kSmall + "objekt x\n", "line 5: expected one of name, drummer, hands"},
        {kSmall + "object x drum radius wide\n", "line 5: expected a number after 'radius'"},
        {kSmall + "object x drum radius\n", "found the end of the line"},
        {kSmall + "object x box\n", "line 5: expected one of drum, cymbal, hi-hat, bell"},
        {kSmall + "object x drum radius 9\n", "x: its radius [m]: expected"},
        {kSmall + "object x drum radius nan\n", "line 5: expected a number"},
        {kSmall + "event y on tambourine\n", "line 5: no object 'tambourine'"},
        {kSmall + "event y drum\n", "expected 'on' and an object"},
        {kSmall + "event y on drum spot 0.3 0\n", "y: distance from the middle"},
        {kSmall + "event y on drum by left-foot\n", "expected a foot that has a pedal"},
        {kSmall + "key 200 hit\n", "expected keys from 0 to 127"},
        {kSmall + "key hit\n", "expected a key"},
        {kSmall + "key 40 41 nothing\n", "no event 'nothing'"},
        {kSmall + "pair hit drum both\n", "expected one of left, right"},
        {kSmall + "script wrist down 1 0\n", "script of wrist: expected 0 first, 1 last"},
        {kSmall + "key 40 hit hit\n", "expected the end of the line, found 'hit'"},
    };
    for (const auto& [text, wanted] : faults) {
        CAPTURE(text);
        CAPTURE(error_of(text));
        CHECK(error_of(text).find("my.kit: ") == 0);
        CHECK(error_of(text).find(wanted) != std::string::npos);
    }
}

TEST_CASE("kit file: on the standard kit real drummers' notes are played without fault") {
    const score::Kit kit = standard_kit();
    for (const auto& path : test::real_files("midi", ".mid")) {
        CAPTURE(path.filename().string());
        const score::Score song = midi_to_score(read_midi_file(path));
        const score::KitPlan plan = score::plan_kit(song, kit);
        CHECK(plan.strokes.size() + plan.left_out.size() + plan.doubles.size() ==
              song.notes.size());
        const score::KitAudit counts = audit(plan, kit);
        CHECK(counts.crossed == 0);
        CHECK(counts.too_fast == 0);
        CHECK(counts.too_often == 0);
    }
}
