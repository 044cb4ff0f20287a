#include "files/recording_file.hpp"

#include <algorithm>
#include <array>

#include "files/text_lines.hpp"

namespace percussionist::files {

namespace {

constexpr std::string_view kTitle = "percussionist recording 1\n";
constexpr std::array<std::string_view, 5> kKinds{"sets", "scor", "hear", "told", "ends"};
constexpr std::size_t kHeader = 16;
constexpr std::uintmax_t kLargestFile = 4ULL << 30U;
constexpr std::uint32_t kLargestRecord = 1U << 30U;
/// Ten years at 4 kHz: more is damage.
constexpr std::int64_t kMostSteps = 1'300'000'000'000;

template <int Bytes>
void append_number(std::string& to, std::uint64_t value) {
    for (int shift = 8 * (Bytes - 1); shift >= 0; shift -= 8)
        to += static_cast<char>(value >> static_cast<unsigned>(shift));
}

std::uint64_t number(std::span<const char> bytes) {
    std::uint64_t value = 0;
    for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
}

class Parser {
  public:
    Parser(std::span<const char> bytes, std::string_view name) : bytes_(bytes), name_(name) {}

    Recording parse() {
        if (!text(0, kTitle.size()).starts_with(kTitle)) {
            fail("'percussionist recording 1'", in_quotes(text(0, kTitle.size() - 1)));
        }
        at_ = kTitle.size();
        while (next()) {
        }
        if (recording_.records.empty()) fail("settings first", "the end of the file");
        return std::move(recording_);
    }

  private:
    [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
        throw RecordingError(std::string(name_) + ": byte " + std::to_string(at_) + ": expected " +
                             expected + ", found " + found);
    }

    [[nodiscard]] std::string_view text(std::size_t at, std::size_t size) const {
        const auto part = bytes_.subspan(std::min(at, bytes_.size()));
        return {part.data(), std::min(size, part.size())};
    }

    RecordKind kind() const {
        const std::string_view letters = text(at_, 4);
        const auto* const found = std::find(kKinds.begin(), kKinds.end(), letters);
        if (found == kKinds.end()) fail("sets, scor, hear, told or ends", in_quotes(letters));
        const auto kind = static_cast<RecordKind>(found - kKinds.begin());
        const bool first = recording_.records.empty();
        if (first != (kind == RecordKind::settings)) {
            fail(first ? "settings first" : "no settings again", in_quotes(letters));
        }
        return kind;
    }

    std::int64_t step() const {
        const auto value = static_cast<std::int64_t>(number(bytes_.subspan(at_ + 8, 8)));
        if (value < recording_.end || value > kMostSteps) {
            fail("a step from " + std::to_string(recording_.end), std::to_string(value));
        }
        return value;
    }

    bool next() {
        if (bytes_.size() - at_ < kHeader) return cut();
        Record record;
        record.kind = kind();
        record.step = step();
        const std::uint64_t size = number(bytes_.subspan(at_ + 4, 4));
        if (size > kLargestRecord) fail("at most 1 GB in a record", std::to_string(size));
        if (size > bytes_.size() - at_ - kHeader) return cut();
        const auto content = bytes_.subspan(at_ + kHeader, size);
        record.bytes.assign(content.begin(), content.end());
        if (record.kind == RecordKind::score &&
            std::find(content.begin(), content.end(), '\0') == content.end()) {
            fail("a score's name", "no end of it");
        }
        recording_.end = record.step;
        at_ += kHeader + size;
        if (record.kind != RecordKind::end) {
            recording_.records.push_back(std::move(record));
            return true;
        }
        if (at_ != bytes_.size()) fail("nothing after the end", "more");
        return false;
    }

    bool cut() {
        recording_.cut = true;
        return false;
    }

    std::span<const char> bytes_;
    std::string_view name_;
    std::size_t at_ = 0;
    Recording recording_;
};

}  // namespace

std::vector<char> pack_score(std::string_view name, std::span<const char> bytes) {
    std::vector<char> packed(name.begin(), name.end());
    packed.push_back('\0');
    packed.insert(packed.end(), bytes.begin(), bytes.end());
    return packed;
}

PackedScore unpack_score(std::span<const char> packed) {
    const auto end = std::find(packed.begin(), packed.end(), '\0');
    const auto size = static_cast<std::size_t>(end - packed.begin());
    return {std::string(packed.begin(), end), packed.subspan(size + 1)};
}

Recording parse_recording(std::span<const char> bytes, std::string_view name) {
    return Parser(bytes, name).parse();
}

Recording read_recording(const std::filesystem::path& path) {
    const std::string bytes = read_text<RecordingError>(path, kLargestFile);
    return parse_recording(bytes, path.filename().string());
}

RecordingWriter::RecordingWriter(const std::filesystem::path& path)
    : path_(path), out_(path, std::ios::binary) {
    out_ << kTitle;
    if (!out_) throw std::runtime_error(path.string() + ": cannot be written");
}

void RecordingWriter::add(RecordKind kind, std::int64_t step, std::span<const char> bytes) {
    std::string header(kKinds.at(static_cast<std::size_t>(kind)));
    append_number<4>(header, bytes.size());
    append_number<8>(header, static_cast<std::uint64_t>(step));
    out_ << header;
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void RecordingWriter::finish(std::int64_t step) {
    add(RecordKind::end, step, {});
    if (!out_.flush()) throw std::runtime_error(path_.string() + ": could not be written");
}

}  // namespace percussionist::files
