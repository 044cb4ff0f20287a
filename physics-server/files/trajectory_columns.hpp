// Which column of a table of positions means what, and in which unit: from its header, or from how
// many there are.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percussionist::files {

/// The columns of one path; -1: not there.
struct PathColumns {
    std::array<int, 3> position{-1, -1, -1};
    std::vector<int> rotation;  ///< 3 (rotation vector), 4 (quaternion w x y z) or 9 (matrix)
    double length_unit = 1.0;   ///< [m]
    double angle_unit = 1.0;    ///< [rad]
    [[nodiscard]] bool complete() const {
        return position[0] >= 0 && position[1] >= 0 && position[2] >= 0;
    }
};

struct TableColumns {
    int time = -1;
    bool counts_frames = false;      ///< the time column holds frame numbers
    double time_unit = 1.0;          ///< [s]
    std::vector<PathColumns> paths;  ///< one, or left and right
};

/// From names, and units under them if there are any; nothing if they do not name a path.
std::optional<TableColumns> columns_named(const std::vector<std::string_view>& names,
                                          const std::vector<std::string_view>& units);

/// From the number of columns, and whether the first counts frames; nothing if it tells nothing.
std::optional<TableColumns> columns_counted(std::size_t count, bool counts_frames);

/// The metres or radians of a unit by name; nothing if it is none.
std::optional<double> unit_named(std::string_view name);

}  // namespace percussionist::files
