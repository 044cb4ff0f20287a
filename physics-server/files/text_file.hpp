// A text as a file.
#pragma once

#include <filesystem>
#include <string>

namespace percussionist::files {

/// Throws std::runtime_error, one line that names the file, if it cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

/// The same in place of what was there, which stays if it cannot be written (a full disk). A link
/// is replaced, not followed.
void replace_text(const std::filesystem::path& path, const std::string& text);

/// An empty file where none was: throws std::runtime_error if there is one, or a link of that name.
void create_new(const std::filesystem::path& path);

}  // namespace percussionist::files
