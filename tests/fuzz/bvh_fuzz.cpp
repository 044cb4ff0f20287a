// Any text: a BVH file is read, or one BvhError comes; all rotations are rotations.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/bvh_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        const motion::Capture capture = files::parse_bvh(text, "fuzz.bvh");
        for (const linear::Quaternion& q : capture.rotations) {
            if (!(std::abs(q.norm() - 1.0) < 1e-6)) std::abort();
        }
    } catch (const files::BvhError&) {
    }
    return 0;
}
