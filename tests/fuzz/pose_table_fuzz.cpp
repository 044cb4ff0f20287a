// Any text: a recording of the tracker is read, and tells sane poses at any time, or one
// std::runtime_error comes.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tracker/recorded_motion.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    tracker::Recording recording;
    try {
        std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
        recording = tracker::read_recording(text, "fuzz.csv");
    } catch (const std::runtime_error&) {
        return 0;
    }
    for (int station = 1; station <= recording.receivers; ++station) {
        for (const double time : {0.0, 0.3 * recording.duration, 1e4}) {
            const motion::Pose pose = recording.motion(station, time);
            const bool sane =
                pose.position.allFinite() && std::abs(pose.orientation.norm() - 1.0) < 1e-6;
            if (!sane) std::abort();
        }
    }
    return 0;
}
