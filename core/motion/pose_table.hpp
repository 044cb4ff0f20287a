// Recorded poses as text that a spreadsheet opens: comma-separated, one header line, SI units.
//
//     time [s],station,x [m],y [m],z [m],qw,qx,qy,qz
//     0.008333,1,0.412,-0.03,0.221,0.9239,0,0.3827,0
//
// The point is the decimal point in every language. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

struct StationPose {
    double time = 0.0;  ///< [s]
    int station = 1;
    linear::Pose pose;
};

constexpr std::string_view kPoseTableHeader = "time [s],station,x [m],y [m],z [m],qw,qx,qy,qz";

std::string to_row(const StationPose& pose);

/// Nothing unless the row has nine finite numbers, a station from 1 to 4 and a quaternion that is
/// not far from unit; spaces and a carriage return do not matter.
std::optional<StationPose> from_row(std::string_view row);

}  // namespace percussionist::motion
