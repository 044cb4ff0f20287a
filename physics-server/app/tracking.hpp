// A clip followed by the simulated body under one kind of control, and how well.
#pragma once

#include <string>
#include <vector>

#include "app/clip_loader.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

/// How the body is to follow: the rows of the report.
struct TrackControl {
    std::string name;  ///< joints, dls, transpose or learnt
    sim::Law law = sim::Law::implicit;
    body::Tracking tracking = body::Tracking::tips;
    body::Inverse inverse = body::Inverse::damped_least_squares;
};

struct TrackOptions {
    double rate = 1000.0;                                ///< steps a second [Hz]
    double frequency = sim::ControlOptions().frequency;  ///< of our law, all joints [Hz]
    double damping = 1.0;                                ///< of it
    double paper_frequency = 20.0;  ///< gain of the papers' law, all joints [Hz]
    double mass_error = 0.0;  ///< of the simulated masses against those reckoned with, a share
    double start = 0.0;       ///< of the part of the clip [s]
    double seconds = 1e9;     ///< at most so much of it
};

/// Root of the mean of squares, and the largest.
struct ErrorSize {
    double sum = 0.0, worst = 0.0;
    long count = 0;
    void take(double error) {
        sum += error * error;
        worst = error > worst ? error : worst;
        ++count;
    }
    [[nodiscard]] double rms() const;
};

/// One moment of a run, by Hand.
struct TrackSample {
    double time = 0.0;  ///< from the beginning of the part [s]
    struct Arm {
        body::Vector3 tip_captured, tip;        ///< world [m]
        double elbow_captured = 0.0;            ///< flexion, 0 straight [rad]
        double elbow_asked = 0.0, elbow = 0.0;  ///< by inverse kinematics; of the body [rad]
        double torque[4] = {0, 0, 0, 0};        ///< shoulder, elbow, wrist, grip [N m]
    } arms[2];
};

struct TrackRun {
    TrackControl control;
    bool stable = true;
    double lasted = 0.0;        ///< simulated [s]; less than asked for if it was not stable
    ErrorSize tip;              ///< of the body's tips against those captured [m]
    ErrorSize asked_tip;        ///< of the targets' tips against those captured [m]
    ErrorSize joint;            ///< of all joints against those asked for [rad]
    ErrorSize joint_captured;   ///< of all joints against those captured [rad]
    ErrorSize elbow_asked;      ///< of the elbows' flexion asked for against that captured [rad]
    ErrorSize elbow;            ///< of the body's [rad]
    double worst_torque = 0.0;  ///< of any arm joint [N m]
    double computing = 0.0;     ///< [s]
    std::vector<TrackSample> samples;  ///< at most 250 a second

    [[nodiscard]] double times_real_time() const { return lasted / computing; }
};

/// All controls, under both laws.
std::vector<TrackControl> all_track_controls();
std::string law_name(sim::Law law);

TrackRun track(const LoadedClip& clip, const TrackControl& control, const TrackOptions& options);

}  // namespace percussionist::app
