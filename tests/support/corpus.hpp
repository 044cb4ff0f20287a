// What fuzzers start from is written into a folder by small programs; this writes one input.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace percussionist::test {

inline void write_input(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
}

}  // namespace percussionist::test
