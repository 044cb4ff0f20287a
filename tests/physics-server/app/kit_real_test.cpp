// Real drum parts on the standard kit, as `percussionist animate` plays them.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "body/animation_check.hpp"
#include "core/score/kit_plan.hpp"
#include "files/kit_file.hpp"
#include "files/midi_file.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

namespace {

score::Score random_score(unsigned seed) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> gap(1.0 / (0.03 * (1 + seed % 8)));
    std::uniform_int_distribution<int> key(35, 59), velocity(1, 127);
    score::Score song;
    double time = 0.0;
    for (int i = 0; i < 200; ++i) {
        if (i % 3 != 0) time += gap(random);
        song.notes.push_back({time, key(random), velocity(random) / 127.0, 9, {}});
    }
    return song;
}

double top_speed(const score::Kit& kit, const body::KitAnimation& animation, double end) {
    body::StickWatch watch(animation, kit);
    body::Posture posture(animation.skeleton());
    body::Placement placement(animation.skeleton());
    for (int i = -240; i / 240.0 < end; ++i) {
        animation.at(i / 240.0, posture, placement);
        watch.see(i / 240.0, placement);
    }
    return watch.top_speed();
}

}  // namespace

TEST_CASE("animation: whatever the notes, no tip is above 20 m/s, no contact early") {
    score::Kit kit = files::standard_kit();
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    note_reach(body::KitPoses(skeleton, kit), kit);
    for (unsigned seed = 0; seed < 8; ++seed) {
        CAPTURE(seed);
        const score::KitPlan plan = plan_kit(random_score(seed), kit);
        const body::KitAnimation animation(kit, plan.strokes);
        CHECK(top_speed(kit, animation, plan.strokes.back().time + 1.0) < 20.0);
        for (const score::KitStroke& stroke : plan.strokes) {
            const body::StrokeCheck check = check_stroke(animation, stroke);
            CHECK(check.off < 0.005);
            CHECK(check.early < 0.001);
        }
    }
}

TEST_CASE("animation of real files: each contact in time and in place, no tip above 20 m/s") {
    score::Kit kit = files::standard_kit();
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    note_reach(body::KitPoses(skeleton, kit), kit);
    for (const score::KitEvent& event : kit.events) {
        CAPTURE(event.name);
        const bool both = event.reach[0] && event.reach[1];
        CHECK((event.foot || both || (event.hand && event.reach[index(*event.hand)])));
    }
    for (const auto& path : test::real_files("midi", ".mid")) {
        CAPTURE(path.filename().string());
        const score::Score song = files::midi_to_score(files::read_midi_file(path));
        const score::KitPlan plan = plan_kit(song, kit);
        const body::KitAnimation animation(kit, plan.strokes);
        double off = 0.0, early = 0.0;
        for (const score::KitStroke& stroke : plan.strokes) {
            const body::StrokeCheck check = check_stroke(animation, stroke);
            off = std::max(off, check.off);
            early = std::max(early, check.early);
        }
        CHECK(off < 0.005);
        CHECK(early < 0.001);
        const double end = plan.strokes.empty() ? 0.0 : plan.strokes.back().time + 1.0;
        CHECK(top_speed(kit, animation, end) < 20.0);
    }
}

TEST_CASE("animation: from object to object a stick goes over what lies between") {
    score::Kit kit = files::standard_kit();
    const body::KitPoses poses(body::make_drummer(kit.drummer), kit);
    body::note_reach(poses, kit);
    for (const score::Limb hand : {score::Limb::left_hand, score::Limb::right_hand}) {
        std::vector<score::KitStroke> strokes;
        for (std::size_t a = 0; a < kit.events.size(); ++a) {
            for (std::size_t b = 0; b < kit.events.size(); ++b) {
                if (!kit.events[a].reach[index(hand)] || !kit.events[b].reach[index(hand)] ||
                    kit.events[a].foot || kit.events[b].foot) {
                    continue;
                }
                for (const std::size_t event : {a, b}) {
                    score::KitStroke stroke;
                    stroke.time = 0.35 * static_cast<double>(strokes.size());
                    stroke.limb = hand;
                    stroke.event = event;
                    strokes.push_back(stroke);
                }
            }
        }
        REQUIRE(strokes.size() > 100);
        const body::KitAnimation animation(kit, strokes);
        body::StickWatch watch(animation, kit);
        body::Posture posture(animation.skeleton());
        body::Placement placement(animation.skeleton());
        for (double t = -1.0; t < strokes.back().time + 1.0; t += 0.002) {
            animation.at(t, posture, placement);
            watch.see(t, placement);
        }
        // One way in a hundred has no room: from a crash behind a cowbell to the floor tom.
        CHECK(100 * watch.through().size() < strokes.size());
    }
}
