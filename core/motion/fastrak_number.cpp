#include "core/motion/fastrak_number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string_view>

namespace percussionist::motion {

namespace {

constexpr double k16BitScale = 8192.0;

/// Right-aligned; std::to_chars, for printf writes the decimal point of the host's language.
void put_text(double value, std::chars_format format, int decimals, std::size_t width, Bytes& out) {
    std::array<char, 64> text{};
    const double sane = std::clamp(std::isfinite(value) ? value : 0.0, -999.99, 999.99);
    const auto end = std::to_chars(text.data(), text.data() + text.size(), sane, format, decimals);
    const auto length = static_cast<std::size_t>(end.ptr - text.data());
    out.insert(out.end(), width > length ? width - length : 0, ' ');
    std::transform(text.data(), end.ptr, std::back_inserter(out),
                   [](char c) { return static_cast<std::uint8_t>(c == 'e' ? 'E' : c); });
}

std::optional<double> get_text(std::string_view text) {
    const auto first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text.remove_prefix(first);
    if (text.front() == '+') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    double value = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::size_t size_of(Notation notation) {
    switch (notation) {
        case Notation::kFloat32:
            return 4;
        case Notation::k16Bit:
            return 2;
        case Notation::kExtended:
            return 13;
        default:
            return 7;
    }
}

void put_number(double value, Notation notation, double full_scale, Bytes& out) {
    switch (notation) {
        case Notation::kTwoDecimals:
            return put_text(value, std::chars_format::fixed, 2, 7, out);
        case Notation::kFourDecimals:
            return put_text(value, std::chars_format::fixed, 4, 7, out);
        case Notation::kExtended:
            put_text(value, std::chars_format::scientific, 5, 12, out);
            out.push_back(' ');
            return;
        case Notation::kFloat32: {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
            for (const int shift : {0, 8, 16, 24}) {
                out.push_back(static_cast<std::uint8_t>(bits >> shift));
            }
            return;
        }
        case Notation::k16Bit: {
            const double scaled = std::round(value / full_scale * k16BitScale);
            const auto n = static_cast<int>(std::clamp(scaled, -k16BitScale, k16BitScale - 1));
            out.push_back(static_cast<std::uint8_t>(n & 0x7F));
            out.push_back(static_cast<std::uint8_t>((n >> 7) & 0x7F));
            return;
        }
    }
}

std::optional<double> get_number(std::span<const std::uint8_t> bytes, Notation notation,
                                 double full_scale) {
    if (notation == Notation::kFloat32) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            bits |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
        }
        const auto value = static_cast<double>(std::bit_cast<float>(bits));
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
    if (notation == Notation::k16Bit) {
        const int raw = (bytes[0] & 0x7F) | (bytes[1] & 0x7F) << 7;
        const int signed_value = raw >= 0x2000 ? raw - 0x4000 : raw;
        return full_scale * signed_value / k16BitScale;
    }
    return get_text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace percussionist::motion
