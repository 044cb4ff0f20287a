#include "files/png.hpp"

#include <algorithm>
#include <stdexcept>

namespace percussionist::files {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& to, std::span<const std::uint8_t> more) {
    to.insert(to.end(), more.begin(), more.end());
}

void append_number(Bytes& to, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        to.push_back(static_cast<std::uint8_t>(value >> static_cast<unsigned>(shift)));
}

std::uint32_t cyclic_check(std::span<const std::uint8_t> bytes) {
    std::uint32_t check = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        check ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            check = (check >> 1U) ^ ((check & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~check;
}

std::uint32_t adler(std::span<const std::uint8_t> bytes) {
    constexpr std::uint32_t kPrime = 65521;
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % kPrime;
        b = (b + a) % kPrime;
    }
    return (b << 16U) | a;
}

void append_chunk(Bytes& to, const char* name, std::span<const std::uint8_t> content) {
    append_number(to, static_cast<std::uint32_t>(content.size()));
    Bytes named(name, name + 4);
    append(named, content);
    append(to, named);
    append_number(to, cyclic_check(named));
}

/// zlib's format, in blocks that are stored as they are.
Bytes stored(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kBlock = 65535;
    Bytes out = {0x78, 0x01};
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
        const std::size_t size = std::min(kBlock, bytes.size() - at);
        const auto low = static_cast<std::uint8_t>(size & 0xFFU);
        const auto high = static_cast<std::uint8_t>(size >> 8U);
        out.push_back(at + size == bytes.size() ? 1 : 0);
        for (const unsigned byte : {+low, +high, 255 - low, 255 - high})
            out.push_back(static_cast<std::uint8_t>(byte));
        append(out, bytes.subspan(at, size));
    }
    append_number(out, adler(bytes));
    return out;
}

}  // namespace

std::vector<std::uint8_t> png(std::size_t width, std::size_t height,
                              std::span<const std::uint8_t> pixels,
                              std::span<const Colour> palette) {
    if (width == 0 || height == 0 || pixels.size() != width * height || palette.empty() ||
        palette.size() > 256) {
        throw std::invalid_argument("png: expected width times height pixels and 1 to 256 colours");
    }
    Bytes header;
    append_number(header, static_cast<std::uint32_t>(width));
    append_number(header, static_cast<std::uint32_t>(height));
    append(header, Bytes{8, 3, 0, 0, 0});  // 8 bits, palette
    Bytes colours;
    for (const Colour& colour : palette) append(colours, colour);
    Bytes lines;
    for (std::size_t row = 0; row < height; ++row) {
        lines.push_back(0);  // no filter
        append(lines, pixels.subspan(row * width, width));
    }
    Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    append_chunk(out, "IHDR", header);
    append_chunk(out, "PLTE", colours);
    append_chunk(out, "IDAT", stored(lines));
    append_chunk(out, "IEND", {});
    return out;
}

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = (three << 8U) | (at + k < bytes.size() ? bytes[at + k] : 0U);
        for (unsigned digit = 0; digit < 4; ++digit) {
            text += at + digit <= bytes.size() ? kDigits[(three >> (18U - 6U * digit)) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace percussionist::files
