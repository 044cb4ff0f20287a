// How something moves, out of its last poses: a cubic through those within a window, by least
// squares, read in the window's middle. So all of it is half a window late: `delay` says how much.
//
// Turning is how fast the direction changes, |v x a| / |v|^2; curvature is that for each metre,
// |v x a| / |v|^3; both are 0 while it hardly moves. Angular velocity is the slope, in the middle,
// of a parabola through the rotation vectors from the pose nearest to it. Pure; real-time safe.
#pragma once

#include <optional>

#include "core/motion/local_fit.hpp"
#include "core/motion/pose_gate.hpp"
#include "core/motion/recent.hpp"

namespace percussionist::motion {

struct GestureFitSettings {
    double window = 0.05;       ///< [s]; as many points as it takes, but 5 at least and 24 at most
    double least_speed = 0.05;  ///< slower has no direction [m/s]
    double longest_gap = 0.1;   ///< between poses; beyond, a new path begins [s]
};

struct Gesture {
    double time = 0.0;                               ///< of the middle [s]
    double delay = 0.0;                              ///< from it to the newest pose [s]
    Vector3 position, velocity, acceleration, jerk;  ///< [m], [m/s], [m/s^2], [m/s^3]
    Vector3 direction = Vector3::Zero();             ///< unit, or 0
    double speed = 0.0;                              ///< [m/s]
    double turning = 0.0;                            ///< [rad/s]
    double curvature = 0.0;                          ///< [1/m]
    Vector3 angular_velocity = Vector3::Zero();      ///< in the frame the poses are in [rad/s]
};

class GestureFit {
  public:
    explicit GestureFit(const GestureFitSettings& settings = {}) : settings_(settings) {}

    /// In order of time. Nothing until there are five.
    std::optional<Gesture> add(const TimedPose& pose) noexcept;
    void reset() noexcept { poses_.clear(); }
    void set(const GestureFitSettings& settings) { settings_ = settings; }

  private:
    static constexpr std::size_t kLeast = 5, kMost = 24;
    std::size_t in_window() const noexcept;
    Vector3 angular_velocity(std::size_t count, double middle) const noexcept;

    GestureFitSettings settings_;
    Recent<TimedPose, kMost> poses_;
};

}  // namespace percussionist::motion
