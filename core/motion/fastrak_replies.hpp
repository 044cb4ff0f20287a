// What a FASTRAK answers: its status, which stations are on, what is in a record. Found anywhere in
// the bytes at hand, for records and garbage may stand before. Source: as fastrak_record.hpp. Pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::motion {

constexpr std::size_t kFastrakStatusBytes = 55;

struct FastrakStatus {
    bool binary = false;
    bool centimetres = false;
    bool compensation = false;
    bool continuous = false;
    char error = ' ';
    std::string version;  ///< of the firmware
    std::string identification;
};

std::optional<FastrakStatus> find_status(std::string_view bytes);
/// The reply to l: which stations are on.
std::optional<std::array<bool, kFastrakStations>> find_stations(std::string_view bytes);
/// The reply to O of a station.
std::optional<std::vector<int>> find_output_list(std::string_view bytes, int station);
/// What the unit complains of: "O1,99: out of range".
std::optional<std::string> find_complaint(std::string_view bytes);

}  // namespace percussionist::motion
