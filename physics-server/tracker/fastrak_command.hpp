// What a FASTRAK is told, byte by byte: single letters act at once, others take parameters up to a
// carriage return. Any bytes are good input; a command is at most 254 long.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::tracker {

struct FastrakCommand {
    char letter = 0;
    bool at_once = false;                       ///< a single letter, without parameters
    std::string text;                           ///< as it came, for complaints
    std::vector<std::optional<double>> values;  ///< empty where left out between commas
};

/// The codes of the unit's own complaints.
enum class Refusal { kMissing = -1, kNotANumber = -2, kOutOfRange = -3, kUnknown = -99 };

struct RefusedCommand {
    std::string text;
    Refusal reason;
};

class FastrakCommandReader {
  public:
    /// A command that is complete with this byte, or why there is none.
    std::optional<std::variant<FastrakCommand, RefusedCommand>> receive(std::uint8_t byte);

  private:
    std::string pending_;
};

}  // namespace percussionist::tracker
