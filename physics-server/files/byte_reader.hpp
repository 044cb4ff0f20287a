// Walks over the bytes of a file and never beyond them; whoever asks for more is told where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace percussionist::files {

/// Something else than expected at a byte; what(): "expected ..., found ...".
struct UnexpectedByte : std::runtime_error {
    UnexpectedByte(std::size_t at_byte, const std::string& what)
        : std::runtime_error(what), at(at_byte) {}
    std::size_t at;
};

/// Bytes as text for a person: what is not printable ASCII becomes '?'.
inline std::string printable(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '?';
    }
    return text;
}

/// A view of bytes [0, end) with a place in it; numbers are big-endian, as in MIDI files.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }

    /// The same bytes from `at` on, ending at `end` (both at most as far as there are bytes).
    [[nodiscard]] ByteReader part(std::size_t at, std::size_t end) const {
        ByteReader reader(bytes_.first(end));
        reader.at_ = at;
        return reader;
    }

    std::uint8_t u8() { return take(1)[0]; }
    std::uint32_t u16() { return number(take(2)); }
    std::uint32_t u32() { return number(take(4)); }

    [[nodiscard]] std::uint8_t peek() const { return part(at_, bytes_.size()).u8(); }

    /// MIDI's quantity of variable length: seven bits a byte, at most four bytes.
    std::uint32_t variable_length() {
        const std::size_t start = at_;
        std::uint32_t value = 0;
        for (int i = 0; i < 4; ++i) {
            const std::uint8_t byte = u8();
            value = (value << 7U) | (byte & 0x7FU);
            if (byte < 0x80) {
                return value;
            }
        }
        throw UnexpectedByte(start,
                             "expected a quantity of at most four bytes, found a longer one");
    }

    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > left()) {
            throw UnexpectedByte(at_, "expected " + std::to_string(count) + " more bytes, found " +
                                          std::to_string(left()));
        }
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }

    /// Whether these characters come next.
    [[nodiscard]] bool comes(std::string_view text) const {
        if (text.size() > left()) {
            return false;
        }
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (bytes_[at_ + i] != static_cast<std::uint8_t>(text[i])) {
                return false;
            }
        }
        return true;
    }

    /// What stands here, for an error message.
    [[nodiscard]] std::string four_letters() const {
        constexpr std::size_t kLetters = 4;
        const auto letters = bytes_.subspan(at_, left() < kLetters ? left() : kLetters);
        return letters.empty() ? "the end of the file" : "'" + printable(letters) + "'";
    }

    [[nodiscard]] UnexpectedByte expected(const std::string& what) const {
        return {at_, "expected " + what + ", found " + four_letters()};
    }

  private:
    static std::uint32_t number(std::span<const std::uint8_t> bytes) {
        std::uint32_t value = 0;
        for (const std::uint8_t byte : bytes) {
            value = (value << 8U) | byte;
        }
        return value;
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace percussionist::files
