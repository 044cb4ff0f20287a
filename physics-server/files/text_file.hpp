// A text as a file.
#pragma once

#include <filesystem>
#include <string>

namespace percussionist::files {

/// Throws std::runtime_error, one line that names the file, if it cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace percussionist::files
