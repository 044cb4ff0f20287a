#include "core/motion/bodhran_player.hpp"

#include <cmath>
#include <numbers>

namespace percussionist::motion {

namespace {

constexpr double kQuaver = 60.0 / 110 / 3;  // a jig at 110 dotted crotchets a minute [s]
constexpr int kBars = 4;
constexpr int kQuavers = 6 * kBars;
constexpr double kPeriod = kQuavers * kQuaver;

/// Down, up, down: the lower end, its back stroke, the lower end; a triplet by both ends each bar.
std::vector<SyntheticStroke> jig() {
    std::vector<SyntheticStroke> strokes;
    for (int i = 0; i < kQuavers; ++i) {
        const double time = (i + 0.5) * kQuaver;
        const bool accent = i % 3 == 0;
        const double r = i % 6 < 3 ? 0.08 : 0.14;
        strokes.push_back({.time = time, .velocity = accent ? 2.6 : 1.6, .r = r, .theta = 0.3});
        if (i % 6 == 4) {
            strokes.push_back(
                {.time = time + 0.5 * kQuaver, .velocity = 1.2, .r = r, .theta = 0.3, .end = 1});
        }
    }
    return strokes;
}

/// One period before and one after, so that the middle one joins on to itself.
std::vector<SyntheticStroke> three_times(const std::vector<SyntheticStroke>& pattern) {
    std::vector<SyntheticStroke> strokes;
    for (const int turn : {-1, 0, 1}) {
        for (SyntheticStroke stroke : pattern) {
            stroke.time += turn * kPeriod;
            strokes.push_back(stroke);
        }
    }
    return strokes;
}

double wave(double time, double period) {
    return std::sin(2 * std::numbers::pi * time / period);
}

}  // namespace

BodhranPlayer::BodhranPlayer() : pattern_(jig()), stick_({}, three_times(pattern_)) {}

double BodhranPlayer::in_pattern(double time) const {
    return time - kPeriod * std::floor(time / kPeriod);
}

Pose BodhranPlayer::world_from_chest(double time) const {
    const Vector3 lean(0.03 * wave(time, 5.3), 0.08 * wave(time, 3.7), 0.10 * wave(time, 7.1));
    return {Vector3(0.30 + 0.02 * wave(time, 3.7), 0.02 * wave(time, 5.3), 0.35),
            linear::quaternion_exp(lean)};
}

Pose BodhranPlayer::chest_from_drum() {
    // The head looks to the player's right, its x axis to the front.
    linear::Matrix3 axes;
    axes.col(0) = Vector3::UnitX();
    axes.col(1) = Vector3::UnitZ();
    axes.col(2) = -Vector3::UnitY();
    return {Vector3(0.20, 0.10, -0.10), linear::Quaternion(axes)};
}

Pose BodhranPlayer::receiver(int station, double time) const {
    Pose chest = world_from_chest(time);
    switch (station) {
        case 1:
            return chest * chest_from_drum() * stick_.drum_from_stick(in_pattern(time));
        case 3: {
            const double press = std::max(0.0, wave(time, kPeriod));
            const Vector3 hand(0.06 + 0.04 * wave(time, kPeriod / 3), -0.05, -0.03 + 0.03 * press);
            return chest * chest_from_drum() * Pose{hand, linear::Quaternion::Identity()};
        }
        case 4:
            return chest * Pose{Vector3(0.05, 0.0, 0.35), linear::Quaternion::Identity()};
        default:
            return chest;
    }
}

std::vector<SyntheticStroke> BodhranPlayer::strokes(double until) const {
    std::vector<SyntheticStroke> all;
    for (int turn = 0; turn * kPeriod < until; ++turn) {
        for (SyntheticStroke stroke : pattern_) {
            stroke.time += turn * kPeriod;
            if (stroke.time <= until) {
                all.push_back(stroke);
            }
        }
    }
    return all;
}

}  // namespace percussionist::motion
