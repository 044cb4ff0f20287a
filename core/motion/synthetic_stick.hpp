// A stick with two round ends that plays a plane: a motion whose strokes are known exactly, to try
// trackers and detectors on.
//
// In the drum's frame the head is the plane z = 0. Each end's centre follows cubics in z: down from
// an apex with nearly constant acceleration, through z = tip radius at a stroke's instant with its
// velocity, below for the time of contact (a head 5 to 10 ms; nothing there, 30 ms and more), out
// again with the rebound's part of the velocity, and up. Both heights together tilt the stick. What
// comes too soon for the apex turns lower. A swing that misses comes to rest above the head and
// goes back. Deterministic; built once, then pure.
#pragma once

#include <array>
#include <vector>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

using linear::Pose;
using linear::Vector3;

struct SyntheticStroke {
    double time = 0.0;      ///< when the end touches the plane [s]
    double velocity = 2.0;  ///< of the end into the plane [m/s]
    double r = 0.1;         ///< where on the head [m]
    double theta = 0.0;     ///< [rad]
    int end = 0;            ///< of the stick: 0 or 1
    double miss = 0.0;      ///< above 0: it stops that far from the head [m]
};

struct SyntheticStickSettings {
    double tip_radius = 0.0125;   ///< [m]
    double half_length = 0.10;    ///< from the middle to the centre of an end [m]
    double apex = 0.06;           ///< of an end's centre above the head [m]
    double contact = 0.008;       ///< below the plane [s]
    double rebound = 0.6;         ///< of the velocity
    double hardest_stop = 100.0;  ///< of a swing that misses [m/s^2]
    double swing = 1.0;           ///< duration of a swing over that of constant acceleration
};

class SyntheticStick {
  public:
    /// Strokes in order of time.
    SyntheticStick(const SyntheticStickSettings& settings, std::vector<SyntheticStroke> strokes);

    /// The stick's middle, its x axis towards end 0, in the drum's frame.
    Pose drum_from_stick(double time) const;
    /// The centre of an end in the stick's frame.
    Vector3 tip(int end) const;
    /// When the end turns back below the plane.
    double turning_time(const SyntheticStroke& stroke) const;

  private:
    struct Knot {
        double time, value, rate;
    };
    using Path = std::vector<Knot>;
    void add_swing(Path& path, const SyntheticStroke& stroke, double next_time,
                   double next_velocity, double next_low) const;
    Path heights_of(int end, const std::vector<SyntheticStroke>& strokes) const;
    static double at(const Path& path, double time);

    SyntheticStickSettings settings_;
    std::array<Path, 2> heights_;
    std::array<Path, 2> middle_;  // x and y
};

}  // namespace percussionist::motion
