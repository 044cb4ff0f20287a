// Small pictures as PNG: one byte a pixel through a palette, not compressed.
// Source: W3C, "Portable Network Graphics (PNG) Specification".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace percussionist::files {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// `pixels` by rows from the top, indices into a palette of up to 256. Throws
/// std::invalid_argument where they are not width times height.
std::vector<std::uint8_t> png(std::size_t width, std::size_t height,
                              std::span<const std::uint8_t> pixels,
                              std::span<const Colour> palette);

std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace percussionist::files
