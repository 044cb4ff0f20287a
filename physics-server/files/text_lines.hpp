// A text file line by line, and its words and numbers: for readers that name the line of an error.
//
// Any line ends (LF, CRLF, CR), a byte order mark, tabs. Views into the text; no copies.
#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace percussionist::files {

/// Walks over the lines of a text.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : rest_(text) {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (rest_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
            rest_.remove_prefix(kByteOrderMark.size());
        }
    }
    /// The next line without its end; nothing after the last.
    std::optional<std::string_view> next() {
        if (rest_.empty()) return std::nullopt;
        ++number_;
        const std::size_t end = rest_.find_first_of("\r\n");
        const std::string_view line = rest_.substr(0, end);
        if (end == std::string_view::npos) {
            rest_ = {};
        } else {
            const bool both = rest_.substr(end, 2) == "\r\n";
            rest_.remove_prefix(end + (both ? 2 : 1));
        }
        return line;
    }
    /// Of the line that came last, from 1.
    [[nodiscard]] int number() const { return number_; }

  private:
    std::string_view rest_;
    int number_ = 0;
};

inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\v\f\0";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// Replaces `words` by those of a line, separated by any of `separators`.
inline void split(std::string_view line, std::string_view separators,
                  std::vector<std::string_view>& words) {
    words.clear();
    while (true) {
        const std::size_t start = line.find_first_not_of(separators);
        if (start == std::string_view::npos) return;
        line.remove_prefix(start);
        const std::size_t end = line.find_first_of(separators);
        words.push_back(line.substr(0, end));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end);
    }
}

/// A number that fills the whole word. What programs write for no number ("nan", "-1.#IND") is NaN.
inline std::optional<double> number_in(std::string_view word) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    if (word.find('#') != std::string_view::npos) return std::numeric_limits<double>::quiet_NaN();
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range && end == word.data() + word.size()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// What stands there, for an error message: printable, and not too long.
inline std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMost = 40;
    std::string shown = "'";
    for (const char c : text.substr(0, kMost)) shown += c >= 0x20 && c < 0x7F ? c : '?';
    if (text.size() > kMost) shown += "...";
    return shown + "'";
}

/// The whole file as text; `Error` naming the file if it cannot be read or is larger than `most`.
template <class Error>
std::string read_text(const std::filesystem::path& path, std::uintmax_t most) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) throw Error(path.string() + ": cannot be opened");
    if (size > most) {
        throw Error(path.string() + ": expected at most " + std::to_string(most >> 20U) +
                    " MB, got " + std::to_string(size >> 20U));
    }
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in) throw Error(path.string() + ": cannot be read");
    return text;
}

}  // namespace percussionist::files
