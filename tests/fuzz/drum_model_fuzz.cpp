// Any text: a model of drums is read, or one std::invalid_argument comes.
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "core/listening/drum_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::listening;
    try {
        model_from_text({reinterpret_cast<const char*>(data), size});
    } catch (const std::invalid_argument&) {
    }
    return 0;
}
