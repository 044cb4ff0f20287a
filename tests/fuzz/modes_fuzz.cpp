// Any text: modes are read, or one std::invalid_argument comes; written, they are read back the
// same.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "core/modal/mode_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::modal;
    std::string written;
    try {
        written = write_modes(parse_modes({reinterpret_cast<const char*>(data), size}));
    } catch (const std::invalid_argument&) {
        return 0;
    }
    if (write_modes(parse_modes(written)) != written) std::abort();
    return 0;
}
