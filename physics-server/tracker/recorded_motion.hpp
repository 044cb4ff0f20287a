// A recording of [fastrak~] as the motion of a simulated unit, from its beginning again at its end.
#pragma once

#include <istream>
#include <string>

#include "tracker/fastrak_unit.hpp"

namespace percussionist::tracker {

struct Recording {
    Motion motion;
    int receivers = 1;      ///< the highest station in it
    double duration = 0.0;  ///< [s]
};

/// Throws std::runtime_error: file, line, what was expected.
Recording read_recording(std::istream& stream, const std::string& name);
Recording read_recording(const std::string& path);

}  // namespace percussionist::tracker
