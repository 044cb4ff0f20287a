#include "app/tracking.hpp"

#include <doctest/doctest.h>

#include "body/stick_motion.hpp"
#include "body/stroke_path.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

namespace {

/// Synthetic strokes of a built-in gesture, by both sticks, as if recorded at 250 Hz.
app::LoadedClip synthetic(const std::string& gesture) {
    const body::StrokeShape shape = body::find_gesture(body::built_in_gestures(), gesture)->shape;
    std::array<std::optional<motion::Trajectory>, 2> paths;
    for (int h = 0; h < 2; ++h) {
        body::StrokePath path;
        body::Aim aim;
        aim.time = 0.8 + 0.2 * h;
        aim.shape = shape;
        aim.rebound = {0.5 * shape.impact, 0.005};
        path.aim(0.0, aim);
        motion::Trajectory trajectory;
        for (int i = 0; i < 400; ++i) {
            const double t = 0.004 * i;
            const double z = path.tip(t).position;
            trajectory.samples.push_back({t, {-0.4 * z * z, h == 0 ? 0.08 : -0.08, z}});
        }
        paths[h] = std::move(trajectory);
    }
    app::LoadedClip clip;
    clip.skeleton = body::make_skeleton(clip.person);
    clip.clip = body::follow_sticks(gesture, clip.skeleton, std::move(paths)).clip;
    return clip;
}

app::TrackControl control(const std::string& name, sim::Law law) {
    for (const app::TrackControl& c : app::all_track_controls()) {
        if (c.name == name && c.law == law) return c;
    }
    return {};
}

}  // namespace

TEST_CASE("our law follows every nuance: tips within 1 mm RMS and 5 mm, joints within 0.1 degree") {
    for (const body::Gesture& g : body::built_in_gestures()) {
        CAPTURE(g.name);
        const app::LoadedClip clip = synthetic(g.name);
        const app::TrackRun run = app::track(clip, control("dls", sim::Law::implicit), {});
        CHECK(run.stable);
        CHECK(run.tip.rms() < 0.001);
        CHECK(run.tip.worst < 0.005);
        CHECK(run.joint.rms() < 0.1 * 3.14159265 / 180.0);
    }
}

TEST_CASE("with masses 20 % wrong the tips stay within 3 mm, always, on every nuance") {
    for (const body::Gesture& g : body::built_in_gestures()) {
        const app::LoadedClip clip = synthetic(g.name);
        for (const double error : {-0.2, 0.2}) {
            CAPTURE(g.name);
            CAPTURE(error);
            app::TrackOptions options;
            options.mass_error = error;
            CHECK(app::track(clip, control("dls", sim::Law::implicit), options).tip.worst < 0.003);
        }
    }
}

TEST_CASE("under the papers' law hybrid control follows the tips better than the joints do") {
    for (const body::Gesture& g : body::built_in_gestures()) {
        CAPTURE(g.name);
        const app::LoadedClip clip = synthetic(g.name);
        const double joints = app::track(clip, control("joints", sim::Law::paper), {}).tip.rms();
        const double hybrid = app::track(clip, control("dls", sim::Law::paper), {}).tip.rms();
        CHECK(hybrid < joints);
    }
}

TEST_CASE("each inverse brings the tips where they are wanted") {
    const app::LoadedClip clip = synthetic("accent");
    for (const char* name : {"dls", "transpose", "learnt"}) {
        CAPTURE(name);
        const app::TrackRun run = app::track(clip, control(name, sim::Law::implicit), {});
        CHECK(run.asked_tip.rms() < 0.002);
    }
}

TEST_CASE("nothing explodes: steps of 0.25 to 4 ms, gains of 2 to 160 Hz, captured and synthetic") {
    app::ClipOptions tennis;
    for (const auto& path : test::real_files("bvh", ".bvh")) {
        if (path.filename().string().find("tennis") == 0) tennis.files = {path};
    }
    std::vector<app::LoadedClip> clips{synthetic("piston")};
    if (!tennis.files.empty()) clips.push_back(app::load_clip(tennis));
    for (const app::LoadedClip& clip : clips) {
        for (const double rate : {250.0, 1000.0, 4000.0}) {
            for (const double gain : {2.0, 160.0}) {
                for (const sim::Law law : {sim::Law::implicit, sim::Law::paper}) {
                    app::TrackOptions options;
                    options.rate = rate;
                    options.frequency = options.paper_frequency = gain;
                    options.seconds = 0.5;
                    options.start = clip.clip->duration() > 5.0 ? 3.5 : 0.5;
                    CAPTURE(rate);
                    CAPTURE(gain);
                    CHECK(app::track(clip, control("dls", law), options).stable);
                }
            }
        }
    }
}
