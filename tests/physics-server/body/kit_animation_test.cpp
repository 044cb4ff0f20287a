#include "body/kit_animation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "body/animation_check.hpp"
#include "core/score/kit_plan.hpp"
#include "support/small_kit.hpp"

using namespace percussionist;
using namespace percussionist::test;
using score::Limb;

namespace {

std::vector<score::KitStroke> groove(double interval) {
    score::Score song = kit_line({kHat, kHat, kSnare, kHat, kHighTom, kMidTom, kFloorTom, kRide,
                                  kHat, kSnare, kSnare, kSnare, kSnare, kRide, kFloorTom, kHat},
                                 interval);
    for (int beat = 0; beat < 8; ++beat) song.notes.push_back(kit_note(0.3 * beat, kKick, 0.4));
    song.notes.push_back(kit_note(6.0, kRide, 1.0));
    song.notes.push_back(kit_note(6.0, kSnare, 0.05));
    return plan_kit(song, small_kit()).strokes;
}

double angle(const body::Quaternion& a, const body::Quaternion& b) {
    return linear::quaternion_log(a.conjugate() * b).norm();
}

double farthest(const body::LimbPose& a, const body::LimbPose& b) {
    double most = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) most = std::max(most, angle(a[j], b[j]));
    return most;
}

}  // namespace

TEST_CASE("animation: every limb is on its spot at the note's time, and not a millisecond before") {
    const score::Kit kit = small_kit();
    const auto strokes = groove(0.15);
    REQUIRE(strokes.size() > 20);
    const body::KitAnimation animation(kit, strokes);
    for (const auto& stroke : strokes) {
        const body::StrokeCheck check = check_stroke(animation, stroke);
        CAPTURE(stroke.time);
        CHECK(check.off < 0.0005);
        CHECK(check.early < 0.001);
    }
}

TEST_CASE("animation: sticks stay below 20 m/s, and joints do not jump") {
    const score::Kit kit = small_kit();
    const body::KitAnimation animation(kit, groove(0.15));
    body::StickWatch watch(animation, kit);
    body::Posture posture(animation.skeleton()), before(animation.skeleton());
    body::Placement placement(animation.skeleton());
    double most = 0.0;
    for (int ms = -1000; ms < 8000; ++ms) {
        animation.at(0.001 * ms, posture, placement);
        watch.see(0.001 * ms, placement);
        for (std::size_t j = 0; ms > -1000 && j < posture.joints.size(); ++j) {
            most = std::max(most, angle(before.joints[j], posture.joints[j]));
        }
        before = posture;
    }
    CHECK(watch.top_speed() < 20.0);
    CHECK(watch.top_speed() > 3.0);
    CHECK(most < 0.06);
}

TEST_CASE("animation: with time to travel no stick goes through a face") {
    const score::Kit kit = small_kit();
    const body::KitAnimation animation(kit, groove(0.4));
    body::StickWatch watch(animation, kit);
    body::Posture posture(animation.skeleton());
    body::Placement placement(animation.skeleton());
    for (int ms = -1000; ms < 9000; ++ms) {
        animation.at(0.001 * ms, posture, placement);
        watch.see(0.001 * ms, placement);
    }
    for (const body::Through& t : watch.through()) {
        CAPTURE(t.time);
        FAIL_CHECK(kit.objects[t.object].name);
    }
}

TEST_CASE("animation: before and after are UP scaled by velocity and elasticity") {
    const score::Kit kit = small_kit();
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    const body::KitPoses poses(skeleton, kit);
    const score::KitStroke stroke{2.0, Limb::right_hand, 3, 0.6, 0};
    const auto keys = key_frames(poses, kit, Limb::right_hand, std::span(&stroke, 1));
    const auto& strike = *poses.of(Limb::right_hand, 3);
    const auto key = [&](body::KeyKind kind) {
        return std::find_if(keys.begin(), keys.end(),
                            [&](const auto& k) { return k.kind == kind; });
    };
    REQUIRE(key(body::KeyKind::before) != keys.end());
    CHECK(farthest(key(body::KeyKind::before)->pose, body::blend(strike.down, strike.up, 0.6)) <
          1e-9);
    CHECK(farthest(key(body::KeyKind::contact)->pose, strike.down) < 1e-9);
    CHECK(key(body::KeyKind::contact)->time == 2.0);
    const double bounce = 0.6 * kit.events[3].elasticity;
    CHECK(farthest(key(body::KeyKind::after)->pose, body::blend(strike.down, strike.up, bounce)) <
          1e-9);
}

TEST_CASE("animation: strokes that overlap share one key frame, lower than either") {
    const score::Kit kit = small_kit();
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    const body::KitPoses poses(skeleton, kit);
    const std::vector<score::KitStroke> strokes{{1.0, Limb::right_hand, 1, 0.8, 0},
                                                {1.1, Limb::right_hand, 1, 0.8, 1}};
    const auto keys = key_frames(poses, kit, Limb::right_hand, strokes);
    const auto merged = std::find_if(keys.begin(), keys.end(),
                                     [](const auto& k) { return k.kind == body::KeyKind::merged; });
    REQUIRE(merged != keys.end());
    CHECK(merged->time > 1.005);
    CHECK(merged->time < 1.1);
    const auto& strike = *poses.of(Limb::right_hand, 1);
    CHECK(farthest(merged->pose, strike.down) < 0.8 * farthest(strike.up, strike.down));
    CHECK(std::is_sorted(keys.begin(), keys.end(),
                         [](const auto& a, const auto& b) { return a.time < b.time; }));
}

TEST_CASE("animation: the foot stays on its plate") {
    const score::Kit kit = small_kit();
    const body::KitAnimation animation(kit, groove(0.15));
    body::Posture posture(animation.skeleton());
    body::Placement placement(animation.skeleton());
    const score::Pedal& pedal = kit.pedals[0];
    for (int i = 0; i < 200; ++i) {
        animation.at(0.01 * i, posture, placement);
        const double up = pedal_up(animation.skeleton(), placement, pedal);
        const auto ball = ball_of(animation.skeleton(), placement, Limb::right_foot);
        CHECK((ball - body::plate_point(pedal, up)).norm() < 0.005);
        CHECK(up > -0.01);
        CHECK(up < 1.01);
    }
}

TEST_CASE("animation: a joint set by hand is where it was set") {
    score::Kit kit = small_kit();
    const body::Vector3 angles(0.1, -0.2, 0.05);
    kit.poses.push_back({Limb::left_hand, 1, true, "wrist", angles});
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    const body::KitPoses poses(skeleton, kit);
    CHECK(angle(poses.of(Limb::left_hand, 1)->up[3], body::from_euler_zyx(angles)) < 1e-9);
    kit.poses.back().joint = "tail";
    CHECK_THROWS_AS(body::KitPoses(skeleton, kit), std::invalid_argument);
}

TEST_CASE("animation: what nobody reaches is said, and by how much") {
    score::Kit kit = small_kit();
    kit.objects[3].middle = {2.0, -0.5, 1.0};
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    CHECK_THROWS_AS(note_reach(body::KitPoses(skeleton, kit), kit), std::invalid_argument);
    kit.objects[3].middle = {0.3, -0.9, 0.8};
    note_reach(body::KitPoses(skeleton, kit), kit);
    CHECK(kit.events[3].reach[1]);
}

TEST_CASE("animation: a script is followed through its points") {
    const std::vector<double> curve{0.0, 0.1, 0.6, 1.0};
    for (std::size_t i = 0; i < curve.size(); ++i) {
        CHECK(body::along(curve, static_cast<double>(i) / 3.0) == doctest::Approx(curve[i]));
    }
}

TEST_CASE("animation: a cymbal swings when it is struck, and comes to rest") {
    score::Kit kit = small_kit();
    kit.objects[3].kind = score::ObjectKind::cymbal;
    kit.events[3].forward = -0.1;
    const std::vector<score::KitStroke> strokes{{1.0, Limb::right_hand, 3, 0.8, 0}};
    const body::KitMotion motion(kit, strokes);
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    const body::Placement placement(skeleton);
    std::vector<body::ObjectState> states;
    motion.at(0.9, skeleton, placement, states);
    CHECK(states[3].turn.norm() == 0.0);
    motion.at(1.15, skeleton, placement, states);
    // Struck on the near side, this side goes down: about the axis to the left, backwards.
    CHECK(states[3].turn.y() < -0.02);
    CHECK(states[3].flash > 0.05);
    motion.at(9.0, skeleton, placement, states);
    CHECK(states[3].turn.norm() < 0.001);
}
