// Files that are written at another's wish, by name alone.
#pragma once

#include <filesystem>
#include <string>

namespace percussionist::app {

/// FOLDER/NAME and the ending. Throws std::runtime_error if NAME is no plain name: letters, digits,
/// - and _, at most 64 of them.
std::filesystem::path named_file(const std::filesystem::path& folder, const std::string& name,
                                 const std::string& ending);

/// Where it lies: "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Whoever asks for files may not fill the disk: throws std::runtime_error if FOLDER holds 100 of
/// that ending, and `path` would be one more.
void require_room(const std::filesystem::path& path);

}  // namespace percussionist::app
