// How well strikes are found in stick movements whose strikes are known, and how many are found
// where there are none: strike_report [FOLDER of fastrak-reaching].
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/motion/free_strike.hpp"
#include "core/motion/plane_strike.hpp"
#include "support/air_strokes.hpp"
#include "support/strike_trials.hpp"

using namespace percussionist;
using namespace percussionist::motion;
using test::Score;
using test::Trial;
using test::TrialSettings;

namespace {

constexpr int kTrials = 20;
constexpr double kTolerance = 0.025;  // [s]

std::vector<double> stroke_times(const std::vector<SyntheticStroke>& strokes, int end) {
    std::vector<double> result;
    for (const auto& stroke : strokes) {
        if (stroke.end == end) {
            result.push_back(stroke.time);
        }
    }
    return result;
}

Score on_plane(const Trial& trial, double ahead, double tolerance) {
    Score sum;
    for (const int end : {0, 1}) {
        PlaneStrikeSettings settings;
        settings.tip_radius = trial.stick.tip_radius;
        settings.ahead = ahead;
        const Pose drum_from_world = trial.world_from_drum.inverse();
        const auto found = test::strikes_of(
            PlaneStrikeDetector(settings), trial.poses,
            [&](const Pose& stick) { return drum_from_world * (stick * trial.motion.tip(end)); });
        sum.add(test::score(stroke_times(trial.strokes, end), test::times(found), tolerance));
    }
    return sum;
}

struct FreeScores {
    Score turning, peak;
};

FreeScores scores(const std::vector<FreeStrike>& found, const std::vector<double>& turns,
                  const std::vector<double>& peaks) {
    std::vector<double> found_peaks;
    for (const auto& strike : found) {
        found_peaks.push_back(strike.peak_time);
    }
    return {test::score(turns, test::times(found), kTolerance),
            test::score(peaks, found_peaks, kTolerance)};
}

FreeScores in_air(const Trial& trial) {
    const auto found = test::strikes_of(FreeStrikeDetector({}), trial.poses,
                                        [&](const Pose& p) { return p * trial.motion.tip(0); });
    std::vector<double> turns;
    for (const auto& stroke : trial.strokes) {
        turns.push_back(trial.motion.turning_time(stroke));
    }
    return scores(found, turns, turns);
}

void row(const std::string& name, const Score& s) {
    std::printf("| %s | %d | %d | %d | %.4f | %.2f | %.2f |\n", name.c_str(), s.truths, s.found,
                s.hits, s.f(), 1e3 * s.bias(), 1e3 * s.deviation());
}

template <class Judge>
Score over_trials(TrialSettings settings, Judge judge) {
    Score sum;
    for (int i = 0; i < kTrials; ++i) {
        settings.seed = static_cast<unsigned>(1000 + i);
        sum.add(judge(test::make_trial(settings)));
    }
    return sum;
}

void plane_rows(const std::string& name, const TrialSettings& settings) {
    const double tolerance = std::max(kTolerance, 1 / settings.rate);
    for (const double ahead : {0.02, 0.0}) {
        row("plane, " + name + ", ahead " + std::to_string(static_cast<int>(1e3 * ahead)) + " ms",
            over_trials(settings, [ahead, tolerance](const Trial& t) {
                return on_plane(t, ahead, tolerance);
            }));
    }
}

void air_rows(const std::string& name, TrialSettings settings) {
    settings.both_ends = false;
    settings.hardest_stop = 25.0;  // with nothing there, a hard stop is a strike
    row("no plane, " + name + ", turning point",
        over_trials(settings, [](const Trial& t) { return in_air(t).turning; }));
    row("no plane, " + name + ", peak",
        over_trials(settings, [](const Trial& t) { return in_air(t).peak; }));
}

/// The families of support/air_strokes.hpp.
void family_rows(const std::string& name, const test::AirSettings& settings, unsigned first_seed) {
    std::printf(
        "\n%s\n\n| family | strikes | found | right | F | bias ms | deviation ms "
        "|\n|---|---|---|---|---|---|---|\n",
        name.c_str());
    for (const auto& family : test::AirStrokes::families()) {
        FreeScores sum;
        for (unsigned i = 0; i < kTrials; ++i) {
            test::AirSettings one = settings;
            one.seed = first_seed + i;
            const auto trial = test::AirStrokes(one).make(family);
            const auto found = test::strikes_of(FreeStrikeDetector({}), trial.poses,
                                                [](const Pose& tip) { return tip.position; });
            const auto one_run = scores(found, trial.turns, trial.peaks);
            sum.turning.add(one_run.turning);
            sum.peak.add(one_run.peak);
        }
        row(family + ", turning point", sum.turning);
        row(family + ", peak", sum.peak);
    }
}

void reaching(const std::string& folder) {
    double seconds = 0.0;
    int strikes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".csv") {
            continue;
        }
        const auto poses = test::reaching_poses(entry.path().string());
        for (const auto& s : test::strikes_of(FreeStrikeDetector({}), poses,
                                              [](const Pose& p) { return p.position; })) {
            ++strikes;
            std::printf("%s t %.3f speed %.2f decel %.0f\n", entry.path().stem().c_str(), s.time,
                        s.speed, s.deceleration);
        }
        seconds += poses.empty() ? 0.0 : poses.back().time;
    }
    std::printf("\nreaching: %d strikes in %.1f s, %.2f a minute\n", strikes, seconds,
                60 * strikes / seconds);
}

}  // namespace

int main(int argc, char** argv) {
    std::puts(
        "| trial | strikes | found | right | F | bias ms | deviation ms "
        "|\n|---|---|---|---|---|---|---|");
    TrialSettings usual;
    plane_rows("120 Hz", usual);
    TrialSettings behind = usual;
    behind.behind = true;
    plane_rows("120 Hz, from behind", behind);
    TrialSettings head = usual;
    head.contact = 0.006;
    plane_rows("120 Hz, on a real head", head);
    TrialSettings deep = usual;
    deep.contact = 0.05;
    plane_rows("120 Hz, 50 ms deep", deep);
    TrialSettings noisy = usual;
    noisy.noise = 1e-3;
    noisy.turn_noise = 3e-3;
    plane_rows("120 Hz, noise 1 mm", noisy);
    TrialSettings sixty = usual;
    sixty.rate = 60;
    plane_rows("60 Hz", sixty);
    TrialSettings slow = usual;
    slow.rate = 30;
    plane_rows("30 Hz", slow);
    air_rows("120 Hz", usual);
    air_rows("120 Hz, on a real head", head);
    air_rows("120 Hz, 50 ms", deep);
    air_rows("120 Hz, noise 1 mm", noisy);
    air_rows("60 Hz", sixty);
    family_rows("Strokes in the air, 120 Hz, seeds that were developed on", {}, 5000);
    family_rows("The same, seeds that were not", {}, 40000);
    family_rows("The same, noise 1 mm", {.noise = 1e-3}, 40000);
    family_rows("The same, 60 Hz", {.rate = 60}, 40000);
    if (argc > 1) {
        reaching(argv[1]);
    }
}
