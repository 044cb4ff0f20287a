// What a person sets on a FASTRAK, in SI, and the commands that bring a unit there.
//
// All of it is sent anew at every start and after every loss of the line: a unit keeps little, and
// its filter's default is not certain. The commands end with their carriage return where they take
// parameters. Source: as fastrak_record.hpp. Pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::motion {

enum class Encoding { kAscii, kFloat32, k16Bit };
enum class Attitude { kQuaternion, kEuler, kCosines };

struct Alignment {
    Vector3 origin = Vector3::Zero();  ///< [m]
    Vector3 on_x = Vector3::UnitX();   ///< a point on the new x axis [m]
    Vector3 on_y = Vector3::UnitY();   ///< a point on the new y axis [m]
};

struct StationSettings {
    Vector3 hemisphere = Vector3::UnitX();  ///< towards the half space it is in; 0: follow it
    Vector3 tip = Vector3::Zero();          ///< of what is measured, in the receiver's frame [m]
    std::optional<Alignment> alignment;
};

/// F, FLOW, FHIGH and FACTOR of the unit's adaptive filter; a steady lag of (1-F)/F cycles.
using Filter = std::array<double, 4>;

struct FastrakSettings {
    Encoding encoding = Encoding::kFloat32;
    Attitude attitude = Attitude::kQuaternion;
    /// Every item twice in a record, so that no damaged byte makes a false pose.
    bool twice = true;
    std::array<bool, kFastrakStations> wanted{};  ///< none: those that the unit has on
    std::array<StationSettings, kFastrakStations> stations;
    std::optional<Filter> position_filter;  ///< none: off
    std::optional<Filter> attitude_filter;
};

/// Records for these settings; with the end of line last.
FastrakLayout layout_for(const FastrakSettings& settings);

/// "O1,2,11,1\r".
std::string output_list_command(int station, const FastrakLayout& layout);

/// All but the output lists, for those stations that are on.
std::vector<std::string> set_up_commands(const FastrakSettings& settings,
                                         const std::array<bool, kFastrakStations>& on);

std::vector<std::string> station_commands(int station, const StationSettings& settings);

}  // namespace percussionist::motion
