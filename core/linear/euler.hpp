// Azimuth, elevation and roll: turns about z, then the new y, then the newest x.
//
//     R = Rz(azimuth) Ry(elevation) Rx(roll), its columns the turned axes in the old frame
//
// With the elevation at +-90 degrees only azimuth -+ roll is defined: the roll is then 0. Source:
// Polhemus, 3SPACE FASTRAK User's Manual (2012), direction cosines. All pure: any thread, real-time
// safe.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/linear/rotation.hpp"

namespace percussionist::linear {

struct EulerAngles {
    double azimuth = 0.0;    ///< [rad], -pi to pi
    double elevation = 0.0;  ///< [rad], -pi/2 to pi/2
    double roll = 0.0;       ///< [rad], -pi to pi
};

inline Quaternion to_quaternion(const EulerAngles& e) {
    return Quaternion(Eigen::AngleAxisd(e.azimuth, Vector3::UnitZ()) *
                      Eigen::AngleAxisd(e.elevation, Vector3::UnitY()) *
                      Eigen::AngleAxisd(e.roll, Vector3::UnitX()));
}

inline EulerAngles to_euler(const Matrix3& m) {
    const double elevation = std::atan2(-m(2, 0), std::hypot(m(0, 0), m(1, 0)));
    if (std::hypot(m(0, 0), m(1, 0)) < 1e-9) {
        return {std::atan2(-m(0, 1), m(1, 1)), elevation, 0.0};
    }
    return {std::atan2(m(1, 0), m(0, 0)), elevation, std::atan2(m(2, 1), m(2, 2))};
}

inline EulerAngles to_euler(const Quaternion& q) {
    return to_euler(q.normalized().toRotationMatrix());
}

}  // namespace percussionist::linear
