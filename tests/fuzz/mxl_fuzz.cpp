// Any bytes: an archive gives at most as many bytes as asked for, or one MusicXmlError comes.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "files/musicxml_file.hpp"
#include "files/mxl_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist::files;
    constexpr std::size_t kMost = 100'000;
    try {
        const std::span bytes(reinterpret_cast<const char*>(data), size);
        if (unpack_mxl(bytes, "fuzz.mxl", kMost).size() > kMost) std::abort();
    } catch (const MusicXmlError&) {
    }
    return 0;
}
