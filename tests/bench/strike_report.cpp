// How well strikes are found in stick movements whose strikes are known, and how many are found
// where there are none: strike_report [FOLDER of fastrak-reaching].
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/motion/free_strike.hpp"
#include "core/motion/plane_strike.hpp"
#include "support/strike_trials.hpp"

using namespace percussionist;
using namespace percussionist::motion;
using test::Score;
using test::Trial;
using test::TrialSettings;

namespace {

constexpr int kTrials = 20;
constexpr double kTolerance = 0.025;  // [s]

std::vector<double> times(const std::vector<SyntheticStroke>& strokes, int end) {
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
        PlaneStrikeDetector detector(settings);
        PoseGate gate;
        const Pose drum_from_world = trial.world_from_drum.inverse();
        std::vector<double> found;
        for (const auto& pose : trial.poses) {
            const auto verdict = gate.judge(pose);
            if (verdict == PoseGate::Verdict::kFresh) {
                detector.reset();
            }
            if (verdict > PoseGate::Verdict::kFresh) {
                continue;
            }
            const auto strike =
                detector.add({pose.time, drum_from_world * (pose.pose * trial.motion.tip(end))});
            if (strike) {
                found.push_back(strike->time);
            }
        }
        sum.add(test::score(times(trial.strokes, end), found, tolerance));
    }
    return sum;
}

struct FreeScores {
    Score turning, peak;
};

FreeScores in_air(const Trial& trial) {
    FreeScores sum;
    for (const int end : {0}) {
        FreeStrikeDetector detector({});
        PoseGate gate;
        std::vector<double> turning, peak, truths;
        for (const auto& stroke : trial.strokes) {
            if (stroke.end == end) {
                truths.push_back(trial.motion.turning_time(stroke));
            }
        }
        for (const auto& pose : trial.poses) {
            const auto verdict = gate.judge(pose);
            if (verdict == PoseGate::Verdict::kFresh) {
                detector.reset();
            }
            if (verdict > PoseGate::Verdict::kFresh) {
                continue;
            }
            if (const auto strike = detector.add({pose.time, pose.pose * trial.motion.tip(end)})) {
                turning.push_back(strike->time);
                peak.push_back(strike->peak_time);
            }
        }
        sum.turning.add(test::score(truths, turning, kTolerance));
        sum.peak.add(test::score(truths, peak, kTolerance));
    }
    return sum;
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

void reaching(const std::string& folder) {
    double seconds = 0.0;
    int strikes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".csv") {
            continue;
        }
        std::ifstream file(entry.path());
        std::string line;
        std::getline(file, line);
        FreeStrikeDetector detector({});
        PoseGate gate;
        double last = 0.0;
        while (std::getline(file, line)) {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream fields(line);
            double time = 0.0;
            Pose pose;
            fields >> time >> pose.position.x() >> pose.position.y() >> pose.position.z();
            linear::Matrix3 m;
            for (int i = 0; i < 9; ++i) {
                fields >> m(i / 3, i % 3);
            }
            pose.orientation = linear::Quaternion(m).normalized();
            last = time;
            const auto verdict = gate.judge({time, pose});
            if (verdict == PoseGate::Verdict::kFresh) {
                detector.reset();
            }
            if (verdict > PoseGate::Verdict::kFresh) {
                continue;
            }
            if (const auto s = detector.add({time, pose.position})) {
                ++strikes;
                std::printf("%s t %.3f speed %.2f decel %.0f\n", entry.path().stem().c_str(),
                            s->time, s->speed, s->deceleration);
            }
        }
        seconds += last;
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
    if (argc > 1) {
        reaching(argv[1]);
    }
}
