// Any text: joint limits are read, or one LimitsError comes; written, they are read back.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "body/limits_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::body;
    LimitsBySegment limits;
    try {
        limits = parse_limits({reinterpret_cast<const char*>(data), size}, "fuzz.limits");
    } catch (const LimitsError&) {
        return 0;
    }
    if (parse_limits(limits_text(limits), "written").size() != limits.size()) std::abort();
    return 0;
}
