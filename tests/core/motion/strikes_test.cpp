// Strikes in stick movements that a tracker saw, with its noise, repeats and jumps; see
// support/strike_trials.hpp. strike_report measures the same on more of them.
#include <doctest/doctest.h>

#include "core/motion/free_strike.hpp"
#include "core/motion/plane_strike.hpp"
#include "support/real_data.hpp"
#include "support/strike_trials.hpp"

#include <fstream>
#include <sstream>

using namespace percussionist;
using namespace percussionist::motion;
using test::Score;
using test::Trial;
using test::TrialSettings;

namespace {

/// Runs one end's path through a detector; its strikes.
template <class Detector, class Place>
auto strikes_of(Detector detector, const std::vector<TimedPose>& poses, Place place) {
    std::vector<typename decltype(detector.add({}))::value_type> found;
    PoseGate gate;
    for (const auto& pose : poses) {
        const auto verdict = gate.judge(pose);
        if (verdict == PoseGate::Verdict::kFresh) {
            detector.reset();
        }
        if (verdict == PoseGate::Verdict::kFresh || verdict == PoseGate::Verdict::kGood) {
            if (const auto strike = detector.add({pose.time, place(pose.pose)})) {
                found.push_back(*strike);
            }
        }
    }
    return found;
}

std::vector<PlaneStrike> on_plane(const Trial& trial, int end, double ahead = 0.02) {
    PlaneStrikeSettings settings;
    settings.tip_radius = trial.stick.tip_radius;
    settings.ahead = ahead;
    const Pose drum_from_world = trial.world_from_drum.inverse();
    return strikes_of(PlaneStrikeDetector(settings), trial.poses, [&](const Pose& stick) {
        return drum_from_world * (stick * trial.motion.tip(end));
    });
}

template <class Strikes>
std::vector<double> times(const Strikes& strikes) {
    std::vector<double> result;
    for (const auto& strike : strikes) {
        result.push_back(strike.time);
    }
    return result;
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
            sum.add(test::score(times(of_end(trial.strokes, end)), times(on_plane(trial, end)),
                                tolerance));
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
    const auto found = strikes_of(PlaneStrikeDetector(small), trial.poses, [&](const Pose& stick) {
        return drum_from_world * (stick * trial.motion.tip(0));
    });
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
                strikes_of(FreeStrikeDetector({}), trial.poses,
                           [&](const Pose& stick) { return stick * trial.motion.tip(0); });
            std::vector<double> turns;
            for (const auto& stroke : trial.strokes) {
                turns.push_back(trial.motion.turning_time(stroke));
            }
            sum.add(test::score(turns, times(found), 0.025));
        }
        CHECK(sum.f() > 0.95);
        CHECK(std::abs(sum.bias()) < 5e-3);
    }
}

TEST_CASE("reaching for things, as a real FASTRAK saw it, strikes nothing") {
    int strikes = 0;
    double seconds = 0.0;
    for (const auto& path : test::real_files("fastrak-reaching", ".csv")) {
        std::ifstream file(path);
        std::string line;
        std::getline(file, line);
        std::vector<TimedPose> poses;
        while (std::getline(file, line)) {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream fields(line);
            TimedPose pose;
            fields >> pose.time >> pose.pose.position.x() >> pose.pose.position.y() >>
                pose.pose.position.z();
            pose.pose.orientation = linear::Quaternion::Identity();
            poses.push_back(pose);
        }
        seconds += poses.empty() ? 0.0 : poses.back().time;
        strikes += static_cast<int>(strikes_of(FreeStrikeDetector({}), poses, [](const Pose& p) {
                                        return p.position;
                                    }).size());
    }
    CHECK(strikes * 60.0 <= 5 * seconds);
}
