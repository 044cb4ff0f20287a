// Any text: a library of gestures is read, or one std::runtime_error comes.
#include <cmath>
#include <stdexcept>

#include "app/gesture_library.hpp"
#include "fuzz/memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const percussionist::test::MemoryFile file(data, size);
    try {
        for (const auto& gesture : percussionist::app::load_gestures(file.path())) {
            if (gesture.name.empty() || !(gesture.shape.impact > 0.0)) std::abort();
        }
    } catch (const std::runtime_error&) {
    }
    return 0;
}
