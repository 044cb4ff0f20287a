// Compressed MusicXML (.mxl): a zip archive in which META-INF/container.xml names the score.
//
// By way of libzip. What comes out is bounded whatever the archive says of it, so that a few
// kilobytes cannot become gigabytes.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace percussionist::files {

/// True for bytes that begin as a zip archive does.
bool is_mxl(std::span<const char> bytes);

/// The MusicXML in it, at most `most` bytes. Throws MusicXmlError naming `name`.
std::vector<char> unpack_mxl(std::span<const char> bytes, std::string_view name, std::size_t most);

}  // namespace percussionist::files
