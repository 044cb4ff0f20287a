// Real drum parts on the standard kit, as `percussionist animate` plays them.
#include <doctest/doctest.h>

#include <algorithm>

#include "body/animation_check.hpp"
#include "core/score/kit_plan.hpp"
#include "files/kit_file.hpp"
#include "files/midi_file.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

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
        body::StickWatch watch(animation, kit);
        body::Posture posture(animation.skeleton());
        body::Placement placement(animation.skeleton());
        const double end = plan.strokes.empty() ? 0.0 : plan.strokes.back().time + 1.0;
        for (int i = 0; i / 240.0 < end; ++i) {
            animation.at(i / 240.0, posture, placement);
            watch.see(i / 240.0, placement);
        }
        CHECK(watch.top_speed() < 20.0);
    }
}
