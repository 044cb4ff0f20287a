// Strikes in stick movements that a tracker saw, with its noise, repeats and jumps; see
// support/strike_trials.hpp. strike_report measures the same on more of them.
#include <doctest/doctest.h>

#include "core/motion/free_strike.hpp"
#include "core/motion/plane_strike.hpp"
#include "support/air_strokes.hpp"
#include "support/real_data.hpp"
#include "support/strike_trials.hpp"

using namespace percussionist;
using namespace percussionist::motion;
using test::Score;
using test::Trial;
using test::TrialSettings;

namespace {

std::vector<PlaneStrike> on_plane(const Trial& trial, int end, double ahead = 0.02) {
    PlaneStrikeSettings settings;
    settings.tip_radius = trial.stick.tip_radius;
    settings.ahead = ahead;
    const Pose drum_from_world = trial.world_from_drum.inverse();
    return test::strikes_of(PlaneStrikeDetector(settings), trial.poses, [&](const Pose& stick) {
        return drum_from_world * (stick * trial.motion.tip(end));
    });
}

std::vector<SyntheticStroke> of_end(const std::vector<SyntheticStroke>& strokes, int end) {
    std::vector<SyntheticStroke> own;
    std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(own),
                 [end](const auto& stroke) { return stroke.end == end; });
    return own;
}

Score plane_score(const TrialSettings& settings, double tolerance) {
    Score sum;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        TrialSettings one = settings;
        one.seed = seed;
        const Trial trial = test::make_trial(one);
        for (const int end : {0, 1}) {
            sum.add(test::score(test::times(of_end(trial.strokes, end)),
                                test::times(on_plane(trial, end)), tolerance));
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("at 120 Hz strikes on a plane are found and timed, from both sides, by both ends") {
    for (const bool behind : {false, true}) {
        TrialSettings settings;
        settings.behind = behind;
        const Score score = plane_score(settings, 0.025);
        CHECK(score.truths > 300);
        CHECK(score.f() > 0.99);
        CHECK(std::abs(score.bias()) < 1e-3);
        CHECK(score.deviation() < 2e-3);
    }
}

TEST_CASE("at 30 Hz most of them are") {
    TrialSettings settings;
    settings.rate = 30;
    settings.shortest = 0.15;
    settings.doubles = 0;
    CHECK(plane_score(settings, 1 / 30.0).f() > 0.95);
}

TEST_CASE("a strike tells its speed, place and side, and is told before it happens") {
    TrialSettings settings;
    settings.both_ends = false;
    settings.missed = 0;
    settings.fastest = 3.0;
    const Trial trial = test::make_trial(settings);
    const auto found = on_plane(trial, 0);
    int ahead = 0;
    for (const PlaneStrike& strike : found) {
        const auto truth = std::min_element(
            trial.strokes.begin(), trial.strokes.end(), [&](const auto& a, const auto& b) {
                return std::abs(a.time - strike.time) < std::abs(b.time - strike.time);
            });
        CHECK(strike.side == 1);
        CHECK(strike.speed == doctest::Approx(truth->velocity).epsilon(0.35));
        const Vector3 place(truth->r * std::cos(truth->theta), truth->r * std::sin(truth->theta),
                            0);
        const Vector3 told(strike.place.r * std::cos(strike.place.theta),
                           strike.place.r * std::sin(strike.place.theta), 0);
        CHECK((told - place).norm() < 0.03);
    }
    PlaneStrikeDetector detector({.tip_radius = trial.stick.tip_radius});
    const Pose drum_from_world = trial.world_from_drum.inverse();
    for (const auto& pose : trial.poses) {
        const auto strike =
            detector.add({pose.time, drum_from_world * (pose.pose * trial.motion.tip(0))});
        ahead += strike && strike->time > pose.time ? 1 : 0;
    }
    CHECK(ahead > 0.5 * static_cast<double>(found.size()));
}

TEST_CASE("what lies on the head, or is laid on it slowly, does not strike") {
    PlaneStrikeDetector detector({.tip_radius = 0.01});
    int strikes = 0;
    for (int i = 0; i < 600; ++i) {
        const double t = i / 120.0;
        const double height = 0.01 + std::max(0.0, 0.1 - 0.05 * t) + 2e-4 * ((i * 7) % 5 - 2);
        strikes += detector.add({t, {0.0, 0.0, height}}) ? 1 : 0;
    }
    CHECK(strikes == 0);
}

TEST_CASE("beyond the drum's rim there is nothing to strike") {
    TrialSettings settings;
    settings.both_ends = false;
    const Trial trial = test::make_trial(settings);
    PlaneStrikeSettings small;
    small.tip_radius = trial.stick.tip_radius;
    small.drum_radius = 1e-3;
    const Pose drum_from_world = trial.world_from_drum.inverse();
    const auto found = test::strikes_of(
        PlaneStrikeDetector(small), trial.poses,
        [&](const Pose& stick) { return drum_from_world * (stick * trial.motion.tip(0)); });
    CHECK(found.size() < 5);
}

TEST_CASE("without a plane strikes are told from the movement, wherever and however it is turned") {
    TrialSettings settings;
    settings.both_ends = false;
    settings.hardest_stop = 25;  // with nothing there, a hard stop is a strike
    for (const double contact : {0.006, 0.0}) {
        Score sum;
        for (unsigned seed = 1; seed <= 5; ++seed) {
            settings.seed = seed;
            settings.contact = contact;
            const Trial trial = test::make_trial(settings);
            const auto found =
                test::strikes_of(FreeStrikeDetector({}), trial.poses,
                                 [&](const Pose& stick) { return stick * trial.motion.tip(0); });
            std::vector<double> turns;
            for (const auto& stroke : trial.strokes) {
                turns.push_back(trial.motion.turning_time(stroke));
            }
            sum.add(test::score(turns, test::times(found), 0.025));
        }
        CHECK(sum.f() > 0.95);
        CHECK(std::abs(sum.bias()) < 5e-3);
    }
}

TEST_CASE("strokes in the air are found whether they turn sharply or round, or stop") {
    for (const auto& family : test::AirStrokes::families()) {
        CAPTURE(family);
        Score sum;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const auto trial = test::AirStrokes({.seed = seed}).make(family);
            const auto found = test::strikes_of(FreeStrikeDetector({}), trial.poses,
                                                [](const Pose& tip) { return tip.position; });
            sum.add(test::score(trial.turns, test::times(found), 0.025));
        }
        CHECK(sum.f() > 0.93);
    }
}

TEST_CASE("a turn's time scale does not depend on how large the movement is") {
    for (const double size : {0.03, 0.1, 0.3}) {
        FreeStrikeDetector detector({});
        std::vector<FreeStrike> found;
        constexpr double kOmega = 2 * M_PI * 3.0;
        for (int i = 0; i < 600; ++i) {
            const double t = i / 120.0;
            if (const auto strike =
                    detector.add({t, {0.0, 0.0, size * 0.5 * (1 + std::cos(kOmega * t))}})) {
                found.push_back(*strike);
            }
        }
        CHECK(found.size() >= 13);
        for (const FreeStrike& strike : found) {
            CHECK(strike.direction.z() == doctest::Approx(-1.0));
            CHECK(strike.speed / strike.deceleration == doctest::Approx(1 / kOmega).epsilon(0.15));
            const double turns = strike.time * 3.0 - 0.5;
            CHECK(std::abs(turns - std::round(turns)) < 0.02);
        }
    }
}

TEST_CASE("reaching for things, as a real FASTRAK saw it, strikes nothing") {
    int strikes = 0;
    double seconds = 0.0;
    for (const auto& path : test::real_files("fastrak-reaching", ".csv")) {
        const auto poses = test::reaching_poses(path);
        seconds += poses.empty() ? 0.0 : poses.back().time;
        strikes +=
            static_cast<int>(test::strikes_of(FreeStrikeDetector({}), poses, [](const Pose& p) {
                                 return p.position;
                             }).size());
    }
    CHECK(strikes * 60.0 <= 5 * seconds);
}
