// A captured motion played on the drum.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/performance.hpp"
#include "support/captured_sticks.hpp"

using namespace percussionist;

namespace {

/// As a file of sticks has it.
std::filesystem::path written(const test::CapturedSticks& sticks) {
    const auto file = std::filesystem::temp_directory_path() / "percussionist-captured.csv";
    std::ofstream out(file);
    out << "time,left_x,left_y,left_z,right_x,right_y,right_z\n";
    const body::Skeleton skeleton = body::make_skeleton({});
    const auto clip = sticks.clip(skeleton);
    for (double t = 0.0; t < clip->duration(); t += 1.0 / sticks.frequency) {
        out << t;
        for (const body::Hand hand : body::kHands) {
            const linear::Vector3 tip = clip->own_tip(t, hand);
            out << ',' << tip.x() << ',' << tip.y() << ',' << tip.z();
        }
        out << '\n';
    }
    return file;
}

void play(app::Performance& performance, const app::LoadedScore& score) {
    performance.load(score.strokes, score.motion);
    performance.play();
    while (performance.playing()) performance.step();
}

}  // namespace

TEST_CASE("captured motion: each of its strokes is one contact, in time, at any tempo") {
    const auto file = written({});
    const app::LoadedScore score = app::load_score(file);
    std::filesystem::remove(file);
    REQUIRE(score.motion);
    REQUIRE(score.strokes.size() >= 14);
    const auto count = static_cast<int>(score.strokes.size());
    app::Performance performance({});
    for (const double tempo : {1.0, 0.7, 1.3}) {
        CAPTURE(tempo);
        performance.player().set_tempo(tempo);
        play(performance, score);
        const app::TimingSummary s = performance.summary();
        CHECK(s.strokes == count);
        CHECK(s.contacts == count);
        CHECK(s.uncalled == 0);
        CHECK(s.worst_error < 0.001);
        const auto& contacts = performance.log().contacts();
        CHECK(contacts[5].event.instant - contacts[3].event.instant ==
              doctest::Approx(0.6 / tempo).epsilon(0.02));
    }
    // And a score afterwards as if nothing had been.
    play(performance, app::load_score({}));
    CHECK(performance.summary().contacts == performance.summary().strokes);
    CHECK(performance.summary().uncalled == 0);
    CHECK(performance.summary().worst_error < 0.003);
}

TEST_CASE("captured motion: stopped he goes back to where he waits; by joints he strikes as well") {
    test::CapturedSticks sticks;
    sticks.wanders = 0.0;  // joints are not bent to meet the head
    const auto file = written(sticks);
    const app::LoadedScore score = app::load_score(file);
    std::filesystem::remove(file);
    app::Performance performance({});
    performance.load(score.strokes, score.motion);
    performance.play();
    for (int i = 0; i < 2000; ++i) performance.step();
    CHECK(performance.simulation().following() != nullptr);
    performance.stop();
    CHECK(performance.simulation().following() == nullptr);
    performance.simulation().set_tracking(body::Tracking::joints);
    play(performance, score);
    CHECK(performance.summary().contacts == performance.summary().strokes);
}
