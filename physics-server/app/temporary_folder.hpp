// A folder of its own, gone with it.
#pragma once

#include <filesystem>

namespace percussionist::app {

class TemporaryFolder {
  public:
    /// Throws std::runtime_error if there can be none.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace percussionist::app
