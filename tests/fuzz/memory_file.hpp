// A file in memory with a path, for readers that want one.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace percussionist::test {

class MemoryFile {
  public:
    MemoryFile(const std::uint8_t* data, std::size_t size) : handle_(memfd_create("fuzz", 0)) {
        if (handle_ < 0 || write(handle_, data, size) != static_cast<ssize_t>(size)) std::abort();
    }
    ~MemoryFile() { close(handle_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(handle_); }

  private:
    int handle_;
};

}  // namespace percussionist::test
