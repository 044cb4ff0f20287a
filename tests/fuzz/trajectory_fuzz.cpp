// Any text: paths of sticks are read and mended, or one TrajectoryError comes; times ascend.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "body/path_repair.hpp"
#include "files/trajectory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        for (motion::Trajectory& path : files::parse_trajectories(text, "fuzz.csv")) {
            body::repair(path);
            for (std::size_t i = 0; i < path.samples.size(); ++i) {
                if (!path.samples[i].position.allFinite()) std::abort();
                if (i > 0 && !(path.samples[i].time > path.samples[i - 1].time)) std::abort();
            }
        }
    } catch (const files::TrajectoryError&) {
    }
    return 0;
}
