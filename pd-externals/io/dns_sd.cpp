#include "io/dns_sd.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace percussionist::io {

namespace {

constexpr std::uint16_t kAddress = 1, kPointer = 12, kService = 33, kInternet = 1;
constexpr std::size_t kMostKept = 64;
constexpr std::size_t kLongestName = 255, kLongestLabel = 63;
constexpr int kMostRecords = 256;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Reads on from a place; once something is missing it fails, and gives zeros.
class Reader {
  public:
    Reader(std::span<const std::uint8_t> packet, std::size_t at) : packet_(packet), at_(at) {}

    bool failed() const { return failed_; }
    std::size_t at() const { return at_; }

    std::uint32_t number(int bytes) {
        std::uint32_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            value = value << 8U | byte();
        }
        return value;
    }
    void skip(std::size_t bytes) {
        failed_ = failed_ || bytes > packet_.size() - at_;
        at_ = failed_ ? packet_.size() : at_ + bytes;
    }

    /// Labels with a dot between them; one may go on at an earlier place of the packet.
    std::string name() {
        std::string text;
        std::optional<std::size_t> back;
        for (std::size_t limit = packet_.size();;) {
            const std::size_t here = at_;
            const std::uint32_t length = byte();
            if (failed_ || length == 0) {
                break;
            }
            if (length >= kElsewhere) {
                const std::size_t there = (length & ~kElsewhere) << 8U | byte();
                back = back ? back : at_;
                failed_ = failed_ || there >= std::min(limit, here);  // ever earlier: it ends
                limit = there;
                at_ = failed_ ? packet_.size() : there;
                continue;
            }
            label(length, text);
        }
        at_ = back.value_or(at_);
        return text;
    }

  private:
    static constexpr std::uint32_t kElsewhere = 0xC0;

    std::uint32_t byte() {
        failed_ = failed_ || at_ >= packet_.size();
        return failed_ ? 0 : packet_[at_++];
    }
    void label(std::size_t length, std::string& to) {
        const std::size_t begin = at_;
        skip(length);
        failed_ = failed_ || length > kLongestLabel || to.size() + length > kLongestName;
        if (!failed_) {
            to += to.empty() ? "" : ".";
            to.append(reinterpret_cast<const char*>(packet_.data()) + begin, length);
        }
    }

    std::span<const std::uint8_t> packet_;
    std::size_t at_;
    bool failed_ = false;
};

struct Record {
    std::string name;
    std::uint32_t type = 0, kind = 0;
    std::size_t content = 0, length = 0;
};

Record read_record(Reader& reader) {
    constexpr int kUnused = 4;  // how long it holds
    Record record;
    record.name = reader.name();
    record.type = reader.number(2);
    record.kind = reader.number(2) & 0x7FFFU;  // the first bit asks for caches to be flushed
    reader.skip(kUnused);
    record.length = reader.number(2);
    record.content = reader.at();
    reader.skip(record.length);
    return record;
}

/// Keeps so many and no more.
template <class Value>
void keep(std::map<std::string, Value>& in, const std::string& name, Value value) {
    if (in.size() < kMostKept || in.contains(name)) {
        in[name] = std::move(value);
    }
}

/// Words may come from anybody: what would not stand on one line of a patch is left out.
std::string printable(const std::string& text) {
    std::string plain;
    std::copy_if(text.begin(), text.end(), std::back_inserter(plain), [](unsigned char c) {
        return c >= ' ' && c != 0x7F &&
               std::string_view(",;\\{}$").find(static_cast<char>(c)) == std::string_view::npos;
    });
    return plain;
}

}  // namespace

Bytes dns_sd_question(const std::string& service) {
    Bytes packet{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};  // one question
    for (std::size_t begin = 0; begin <= service.size();) {
        const std::size_t end = std::min(service.find('.', begin), service.size());
        packet.push_back(static_cast<std::uint8_t>(end - begin));
        packet.insert(packet.end(), service.begin() + static_cast<std::ptrdiff_t>(begin),
                      service.begin() + static_cast<std::ptrdiff_t>(end));
        begin = end + 1;
    }
    for (const int byte : {0, 0, static_cast<int>(kPointer), 0, static_cast<int>(kInternet)}) {
        packet.push_back(static_cast<std::uint8_t>(byte));
    }
    return packet;
}

void DnsSdAnswers::take(std::span<const std::uint8_t> packet) {
    constexpr std::size_t kCounts = 4;
    Reader reader(packet, kCounts);
    const std::uint32_t questions = reader.number(2);
    const std::uint32_t records = reader.number(2) + reader.number(2) + reader.number(2);
    for (std::uint32_t i = 0; i < questions && !reader.failed(); ++i) {
        reader.name();
        reader.skip(4);
    }
    for (std::uint32_t i = 0; i < std::min<std::uint32_t>(records, kMostRecords); ++i) {
        const Record record = read_record(reader);
        if (reader.failed()) {
            return;
        }
        Reader content(packet, record.content);
        if (record.kind == kInternet && record.type == kAddress && record.length == 4) {
            keep(addresses_, lower(record.name), content.number(4));
        } else if (record.kind == kInternet && record.type == kService &&
                   lower(record.name).ends_with('.' + service_)) {
            content.skip(4);  // priority and weight
            const auto port = static_cast<std::uint16_t>(content.number(2));
            const std::string host = lower(content.name());
            if (!content.failed()) {
                keep(places_, record.name, Place{host, port});
            }
        }
    }
}

std::vector<FoundServer> DnsSdAnswers::found() const {
    std::vector<FoundServer> all;
    for (const auto& [name, place] : places_) {
        const auto address = addresses_.find(place.host);
        if (address != addresses_.end() && address->second != 0 && place.port != 0) {
            const std::string own = name.substr(0, name.size() - service_.size() - 1);
            all.push_back({printable(own), address->second, place.port});
        }
    }
    return all;
}

}  // namespace percussionist::io
