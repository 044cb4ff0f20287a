// Files that are written at another's wish, by name alone.
#pragma once

#include <filesystem>
#include <string>

namespace percussionist::app {

/// FOLDER/NAME and the ending. Throws std::runtime_error if NAME is no plain name: letters, digits,
/// - and _, at most 64 of them.
std::filesystem::path named_file(const std::filesystem::path& folder, const std::string& name,
                                 const std::string& ending);

}  // namespace percussionist::app
