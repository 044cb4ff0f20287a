// Paths of sticks from CSV files: text in, plain values in SI units out.
//
// Two forms, told apart by their columns:
//   - named: a header line with t or time (or frame), x y z, and if there is a rotation rx ry rz
//     (rotation vector), qw qx qy qz, or m00 ... m22. Units stand with the names, as in x_mm, t_ms
//     or rx[deg]; without, they are s, m and rad. "left_" and "right_" before the names of position
//     and rotation make two paths.
//   - recordings of mallets: any header lines, then frame number, rotation vector in degrees,
//     position in millimetres (7 columns; 13 for a left and a right mallet); names RX ... TZ may
//     stand above. Frames come `rate` times a second.
// Without names, 4, 7, 8 or 13 columns beginning with a time are t x y z and a rotation of 0, 3, 4
// or 9 numbers. Separators are commas, semicolons, tabs or blanks. Cells that are empty or no
// number to their program (NaN) are a gap; times that do not ascend are left out; both with a
// warning. Anything else gives one TrajectoryError with file, line and what was expected.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/motion/capture.hpp"

namespace percussionist::files {

/// what(): "legato.csv: line 14: expected a number, got 'abc'"
struct TrajectoryError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct TrajectoryOptions {
    double rate = 250.0;  ///< frames a second of a file that counts frames [Hz]
    /// Where the tip is in the frame of what was recorded [m].
    linear::Vector3 tip_offset = linear::Vector3::Zero();
};

/// One path, or two: left, right. `name` is what errors call the file. Throws TrajectoryError.
std::vector<motion::Trajectory> parse_trajectories(std::string_view text, std::string_view name,
                                                   const TrajectoryOptions& options = {});

/// Throws TrajectoryError, also for a file that cannot be opened or is above 256 MB.
std::vector<motion::Trajectory> read_trajectory_file(const std::filesystem::path& path,
                                                     const TrajectoryOptions& options = {});

}  // namespace percussionist::files
