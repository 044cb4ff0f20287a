// Any text: a skeleton's map is read, with names for each segment that it has, or one MapError
// comes.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "body/ready_skeleton_maps.hpp"
#include "body/skeleton_map.hpp"

namespace percussionist::body {
const std::vector<std::pair<std::string_view, std::string_view>> kReadySkeletonMaps;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const auto map =
            body::parse_skeleton_map({reinterpret_cast<const char*>(data), size}, "fuzz.map");
        motion::Capture capture;
        for (const auto& [segment, names] : map.names) {
            if (names.empty()) std::abort();
            capture.joints.emplace_back();
            capture.joints.back().name = names.front();
        }
        body::match(capture, map);
    } catch (const body::MapError&) {
    }
    return 0;
}
