// Stick movements whose strikes are known, as a tracker would see them, and how well strikes found
// in them agree.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/motion/pose_gate.hpp"
#include "core/motion/synthetic_stick.hpp"

namespace percussionist::test {

using motion::Pose;
using motion::SyntheticStick;
using motion::SyntheticStickSettings;
using motion::SyntheticStroke;
using motion::TimedPose;
using motion::Vector3;

struct Trial {
    SyntheticStickSettings stick;
    std::vector<SyntheticStroke> strokes;
    std::vector<SyntheticStroke> misses;
    Pose world_from_drum;
    std::vector<TimedPose> poses;  ///< of the stick, in the world
    SyntheticStick motion{{}, {}};
};

struct TrialSettings {
    unsigned seed = 1;
    double rate = 120.0;                                 ///< [1/s]
    double duration = 30.0;                              ///< [s]
    double noise = 3e-4;                                 ///< of a position, per axis [m]
    double turn_noise = 1e-3;                            ///< of an orientation, per axis [rad]
    double repeats = 0.01, jumps = 0.002, lost = 0.005;  ///< parts of all records
    double slowest = 0.6, fastest = 4.0;                 ///< strokes [m/s]
    double shortest = 0.09, longest = 0.6;               ///< between strokes of one end [s]
    double missed = 0.1;                                 ///< swings that do not reach
    double doubles = 0.15;                               ///< strokes that come twice, 70 to 90 ms
    double contact = 0.0;         ///< [s]; 0: from 5 to 50 ms, another in each trial
    double hardest_stop = 100.0;  ///< of swings that do not reach [m/s^2]
    bool both_ends = true;
    bool behind = false;  ///< plays on the other side of the head
};

inline Trial make_trial(const TrialSettings& s) {
    std::mt19937 random(s.seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random);
    };
    std::normal_distribution<> gauss;
    const auto vector = [&](double scale) {
        return Vector3(scale * gauss(random), scale * gauss(random), scale * gauss(random));
    };
    Trial trial;
    trial.stick.tip_radius = uniform(0.008, 0.016);
    trial.stick.apex = uniform(0.05, 0.12);
    trial.stick.rebound = uniform(0.3, 0.8);
    trial.stick.swing = uniform(0.8, 1.3);
    trial.stick.contact = s.contact > 0.0 ? s.contact : uniform(0.005, 0.05);
    trial.stick.hardest_stop = s.hardest_stop;
    trial.world_from_drum = {vector(0.3), linear::quaternion_exp(vector(1.0))};
    // The hand accelerates a stick's end by no more than 120 m/s^2, and wanders over the head.
    const double fastest =
        std::min(s.fastest, std::sqrt(2 * 120 * (trial.stick.apex - trial.stick.tip_radius)));
    Vector3 place(0.06, 0.02, 0.0);
    std::vector<SyntheticStroke> all;
    for (double time = 0.7; time < s.duration - 0.5;) {
        place = 0.9 * place + vector(0.015);
        SyntheticStroke stroke{.time = time,
                               .velocity = uniform(s.slowest, fastest),
                               .r = std::hypot(place.x(), place.y()),
                               .theta = std::atan2(place.y(), place.x()),
                               .end = s.both_ends && uniform(0, 1) < 0.4 ? 1 : 0};
        const bool miss = uniform(0, 1) < s.missed;
        stroke.miss = miss ? uniform(0.01, 0.03) : 0.0;
        all.push_back(stroke);
        if (!miss && uniform(0, 1) < s.doubles) {
            stroke.time += uniform(0.07, 0.09) + trial.stick.contact;
            stroke.velocity = std::min(stroke.velocity, 2.0);
            all.push_back(stroke);
        }
        time = stroke.time + uniform(s.shortest, s.longest) + trial.stick.contact;
    }
    for (const auto& stroke : all) {
        (stroke.miss > 0 ? trial.misses : trial.strokes).push_back(stroke);
    }
    trial.motion = SyntheticStick(trial.stick, all);
    // Turned about x, the head is played from behind.
    const Pose flip{Vector3::Zero(), linear::quaternion_exp({M_PI, 0.0, 0.0})};
    for (double time = 0.0; time < s.duration; time += 1 / s.rate) {
        if (uniform(0, 1) < s.lost) {
            continue;
        }
        Pose pose = trial.motion.drum_from_stick(time);
        pose = trial.world_from_drum * (s.behind ? flip * pose : pose);
        pose.position += vector(s.noise);
        pose.orientation = pose.orientation * linear::quaternion_exp(vector(s.turn_noise));
        if (uniform(0, 1) < s.jumps) {
            pose.position += vector(0.5);
        }
        if (!trial.poses.empty() && uniform(0, 1) < s.repeats) {
            pose = trial.poses.back().pose;
        }
        trial.poses.push_back({time, pose});
    }
    return trial;
}

/// Runs one end's path through the gate and a detector; its strikes.
template <class Detector, class Place>
auto strikes_of(Detector detector, const std::vector<TimedPose>& poses, Place place) {
    std::vector<typename decltype(detector.add({}))::value_type> found;
    motion::PoseGate gate;
    for (const auto& pose : poses) {
        const auto verdict = gate.judge(pose);
        if (verdict == motion::PoseGate::Verdict::kFresh) {
            detector.reset();
        }
        if (verdict == motion::PoseGate::Verdict::kFresh ||
            verdict == motion::PoseGate::Verdict::kGood) {
            if (const auto strike = detector.add({pose.time, place(pose.pose)})) {
                found.push_back(*strike);
            }
        }
    }
    return found;
}

template <class Strikes>
std::vector<double> times(const Strikes& strikes) {
    std::vector<double> result;
    for (const auto& strike : strikes) {
        result.push_back(strike.time);
    }
    return result;
}

/// A recording of fastrak-reaching: time, position and the matrix by rows.
inline std::vector<TimedPose> reaching_poses(const std::string& path) {
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
        linear::Matrix3 matrix;
        for (int i = 0; i < 9; ++i) {
            fields >> matrix(i / 3, i % 3);
        }
        pose.pose.orientation = linear::Quaternion(matrix).normalized();
        poses.push_back(pose);
    }
    return poses;
}

struct Score {
    int truths = 0, found = 0, hits = 0;
    double sum = 0.0, squares = 0.0;  ///< of the errors [s]

    double f() const { return truths + found > 0 ? 2.0 * hits / (truths + found) : 1.0; }
    double bias() const { return sum / std::max(hits, 1); }
    double deviation() const {
        return std::sqrt(std::max(0.0, squares / std::max(hits, 1) - bias() * bias()));
    }
    void add(const Score& other) {
        truths += other.truths;
        found += other.found;
        hits += other.hits;
        sum += other.sum;
        squares += other.squares;
    }
};

/// Each truth with the nearest find within the tolerance, each find once.
inline Score score(const std::vector<double>& truths, std::vector<double> found, double tolerance) {
    Score result{.truths = static_cast<int>(truths.size()),
                 .found = static_cast<int>(found.size())};
    for (const double truth : truths) {
        const auto nearest = std::min_element(
            found.begin(), found.end(),
            [truth](double a, double b) { return std::abs(a - truth) < std::abs(b - truth); });
        if (nearest != found.end() && std::abs(*nearest - truth) <= tolerance) {
            ++result.hits;
            result.sum += *nearest - truth;
            result.squares += (*nearest - truth) * (*nearest - truth);
            found.erase(nearest);
        }
    }
    return result;
}

}  // namespace percussionist::test
