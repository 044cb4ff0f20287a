#include "io/osc_check.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "io/osc_packet.hpp"

namespace percussionist::io {

namespace {

constexpr int kDeepest = 8;
constexpr std::size_t kWord = 4;
constexpr std::size_t kBundleHeader = 16;

/// A stretch of a packet that is walked over.
class Walk {
  public:
    explicit Walk(std::span<const std::uint8_t> bytes, std::size_t start = 0)
        : bytes_(bytes), start_(start) {}

    bool done() const { return at_ == bytes_.size(); }
    std::size_t left() const { return bytes_.size() - at_; }
    bool comes(std::string_view text) const {
        return text.size() <= left() && std::equal(text.begin(), text.end(), bytes_.begin() + at_);
    }

    [[noreturn]] void refuse(const std::string& expected) const {
        throw MalformedOsc("byte " + std::to_string(start_ + at_) + ": expected " + expected);
    }
    void skip(std::size_t count, const char* what) {
        if (count > left()) {
            refuse(what);
        }
        at_ += count;
    }
    std::size_t size() {
        if (left() < kWord) {
            refuse("a size of 4 bytes");
        }
        const auto* const p = bytes_.data() + at_;
        at_ += kWord;
        return std::size_t{p[0]} << 24U | std::size_t{p[1]} << 16U | std::size_t{p[2]} << 8U | p[3];
    }
    /// To the zero that ends it, and on to a whole word.
    std::string_view text() {
        const auto rest = bytes_.subspan(at_);
        const auto end = std::find(rest.begin(), rest.end(), 0);
        if (end == rest.end()) {
            refuse("a text that ends");
        }
        const auto length = static_cast<std::size_t>(end - rest.begin());
        const auto* const letters = reinterpret_cast<const char*>(rest.data());
        const std::size_t whole = (length / kWord + 1) * kWord;
        // oscpack looks for the end at every fourth byte alone.
        const bool padded = whole <= rest.size() &&
                            std::all_of(end, rest.begin() + static_cast<std::ptrdiff_t>(whole),
                                        [](std::uint8_t byte) { return byte == 0; });
        if (!padded) {
            refuse("zeros up to a multiple of 4 bytes");
        }
        at_ += whole;
        return {letters, length};
    }
    Walk part(std::size_t count) {
        const Walk inner(bytes_.subspan(at_, count), start_ + at_);
        at_ += count;
        return inner;
    }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t start_;
    std::size_t at_ = 0;
};

void check_blob(Walk& walk) {
    const std::size_t size = walk.size();
    if (size > walk.left()) {
        walk.refuse("a blob that fits the packet");
    }
    walk.skip((size + kWord - 1) / kWord * kWord, "zeros up to a multiple of 4 bytes");
}

void check_argument(Walk& walk, char type) {
    switch (type) {
        case 'T':
        case 'F':
        case 'N':
        case 'I':
            return;
        case 'i':
        case 'f':
        case 'c':
        case 'r':
        case 'm':
            return walk.skip(kWord, "4 bytes of an argument");
        case 'h':
        case 't':
        case 'd':
            return walk.skip(2 * kWord, "8 bytes of an argument");
        case 's':
        case 'S':
            walk.text();
            return;
        case 'b':
            return check_blob(walk);
        default:
            walk.refuse("an argument of a known type");
    }
}

void check_brackets(const Walk& walk, std::string_view types) {
    int open = 0;
    for (const char type : types) {
        open += type == '[' ? 1 : type == ']' ? -1 : 0;
        if (open < 0) {
            walk.refuse("an array to begin before it ends");
        }
    }
    if (open > 0) {
        walk.refuse("an array to end");
    }
}

void check_message(Walk walk) {
    if (!walk.comes("/")) {
        walk.refuse("an address that begins with /");
    }
    walk.text();
    if (walk.done()) {
        return;
    }
    if (!walk.comes(",")) {
        walk.refuse("types that begin with ,");
    }
    const std::string_view types = walk.text().substr(1);
    check_brackets(walk, types);
    for (const char type : types) {
        if (type != '[' && type != ']') {
            check_argument(walk, type);
        }
    }
    if (!walk.done()) {
        walk.refuse("the end of the message");
    }
}

void check_element(Walk walk, int depth) {
    if (walk.left() % kWord != 0 || walk.done()) {
        walk.refuse("a multiple of 4 bytes, not " + std::to_string(walk.left()));
    }
    if (!walk.comes("#")) {
        return check_message(walk);
    }
    if (!walk.comes({"#bundle", 8})) {
        walk.refuse("#bundle");
    }
    if (depth == kDeepest) {
        walk.refuse("bundles at most " + std::to_string(kDeepest) + " deep");
    }
    walk.skip(kBundleHeader, "a time tag of 8 bytes");
    while (!walk.done()) {
        const std::size_t size = walk.size();
        if (size > walk.left()) {
            walk.refuse("an element that fits the packet");
        }
        check_element(walk.part(size), depth + 1);
    }
}

}  // namespace

void check_osc(std::span<const std::uint8_t> packet) {
    check_element(Walk(packet), 0);
}

}  // namespace percussionist::io
