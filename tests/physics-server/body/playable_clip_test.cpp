#include "body/playable_clip.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support/captured_sticks.hpp"

using namespace percussionist;
using body::PlayableClip;

TEST_CASE("lift: stays before and after, goes from one height to the next without overshooting") {
    body::Lift lift;
    CHECK(lift.at(1.0) == 0.0);
    lift.add(1.0, 0.02);
    lift.add(1.5, -0.01);
    CHECK(lift.at(0.0) == 0.02);
    CHECK(lift.at(9.0) == -0.01);
    double last = 0.02;
    for (double t = 1.0; t < 1.5; t += 0.01) {
        const double here = lift.at(t);
        CHECK(here <= last);
        last = here;
    }
    // Neither speed nor acceleration jumps where it begins to move.
    CHECK(std::abs(lift.at(1.001) - 0.02) < 1e-8);
}

TEST_CASE("playable clip: each captured stroke comes down to the one place, at its time") {
    const test::CapturedSticks sticks;
    const body::Skeleton skeleton = body::make_skeleton({});
    const PlayableClip clip(sticks.clip(skeleton), skeleton);
    // Whether the first and the last moment are strokes is open: they have no way down, or up.
    REQUIRE(clip.strokes().size() >= static_cast<std::size_t>(sticks.strokes - 2));
    CHECK(clip.worst_lift() > 0.01);
    CHECK(clip.worst_lift() < 0.05);
    body::Posture rest(skeleton);
    for (const body::CapturedStroke& stroke : clip.strokes()) {
        CAPTURE(stroke.touch);
        const double number = stroke.touch / sticks.apart;
        CHECK(std::abs(number - std::round(number)) * sticks.apart < 0.006);
        const auto height = [&](double t) {
            return clip.targets(t, rest)[static_cast<int>(stroke.hand)].tip.z() - clip.place().z();
        };
        CHECK(std::abs(height(stroke.touch)) < 2e-4);
        CHECK(std::abs(height(stroke.leave)) < 2e-4);
        CHECK(height(0.5 * (stroke.touch + stroke.leave)) < -5e-4);
        CHECK(height(stroke.touch - 0.1) > 0.05);
        CHECK(clip.in_head(0.5 * (stroke.touch + stroke.leave), stroke.hand));
        CHECK_FALSE(clip.in_head(stroke.touch - 0.01, stroke.hand));
        CHECK_FALSE(clip.in_head(stroke.leave + 0.01, stroke.hand));
    }
}

TEST_CASE("playable clip: a stick that hangs still has no strokes") {
    test::CapturedSticks sticks;
    sticks.rise = 0.0;
    const body::Skeleton skeleton = body::make_skeleton({});
    const PlayableClip clip(sticks.clip(skeleton), skeleton);
    CHECK(clip.strokes().empty());
    CHECK(clip.worst_lift() == 0.0);
}
