// A drum that is not there: a plane with a middle, and where on it something is.
//
// The drum's frame has its origin in the middle of the head and z out of it. A plane through taps
// is the one with the least squares of distances; its middle is that of the taps, its z axis points
// to where the stick is held, x is level as nearly as can be. Pure.
#pragma once

#include <span>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

using linear::Pose;
using linear::Vector3;

struct Place {
    double r = 0.0;      ///< from the middle [m]
    double theta = 0.0;  ///< from x towards y [rad]
};

inline Place place_of(const Vector3& point_drum) {
    return {std::hypot(point_drum.x(), point_drum.y()), std::atan2(point_drum.y(), point_drum.x())};
}

struct FittedPlane {
    Pose world_from_drum;
    double residual = 0.0;  ///< of the taps about it, root mean square [m]
};

/// The taps are where the tip's centre was, `tip_radius` above the surface on the side of `above`.
/// Throws std::invalid_argument for fewer than three taps, or taps on a line.
FittedPlane fit_plane(std::span<const Vector3> taps, const Vector3& above, double tip_radius);

}  // namespace percussionist::motion
