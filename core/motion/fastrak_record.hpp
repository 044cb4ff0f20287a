// A data record of the Polhemus FASTRAK: bytes <-> a pose in SI. Both ends of the line use it.
//
// A record is '0', the station '1' to '4', an error character, then the items of the output list in
// its order: as text, as little-endian float32 (binary), or as pairs of 7-bit bytes ("16BIT").
// Inches, centimetres and degrees end here. There is no checksum: decode() takes a record only if
// every fixed byte is in its place, every number is finite and in range, orientations are unit, and
// items that were asked for twice are the same twice.
//
// Source: Polhemus, 3SPACE FASTRAK User's Manual (1993; Rev G 2012). All pure: any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

using linear::Pose;
using linear::Quaternion;
using linear::Vector3;
using Bytes = std::vector<std::uint8_t>;

constexpr int kFastrakStations = 4;
constexpr std::size_t kFastrakMostItems = 32;
constexpr std::size_t kFastrakMostBytes = 254;
constexpr double kFastrakCycle = 1.0 / 120.0;  ///< one receiver a cycle [s]
constexpr double kFastrakLatency = 3.75e-3;    ///< from the measured instant to the first byte [s]
constexpr double kFastrakReach = 5.0;          ///< no true position is further off [m]

/// How a record of one station is written.
struct FastrakLayout {
    std::vector<int> items{2, 4, 1};
    bool binary = false;
    bool centimetres = false;
    bool cosine_rows = false;  ///< items 5, 6, 7 are the matrix's rows, not the turned axes
};

struct FastrakReading {
    int station = 1;
    char error = ' ';  ///< the last error of the unit, see error_name()
    Pose pose;
    Vector3 relative = Vector3::Zero();  ///< position less that of the record before [m]
    bool button = false;                 ///< of a stylus
    bool has_position = false;
    bool has_orientation = false;
};

/// Whether the unit knows the item.
bool is_fastrak_item(int item);

/// Bytes of a whole record; nothing if an item is not known or there are too many.
std::optional<std::size_t> record_size(const FastrakLayout& layout);

void encode(const FastrakReading& reading, const FastrakLayout& layout, Bytes& out);

/// Nothing unless these bytes are a record of this layout from first to last.
std::optional<FastrakReading> decode(std::span<const std::uint8_t> record,
                                     const FastrakLayout& layout);

/// "saturation" for 'j', and so on; "none" for a space.
const char* error_name(char error);

}  // namespace percussionist::motion
