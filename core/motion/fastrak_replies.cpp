#include "core/motion/fastrak_replies.hpp"

#include <algorithm>
#include <charconv>

namespace percussionist::motion {

namespace {

constexpr std::string_view kComplaint = "*ERROR*";

std::optional<unsigned> hexadecimal(std::string_view text) {
    unsigned value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::string trimmed(std::string_view text) {
    std::string printable;
    for (const char c : text) {
        printable += c >= ' ' && c <= '~' ? c : '?';
    }
    const auto first = printable.find_first_not_of(' ');
    const auto last = printable.find_last_not_of(' ');
    return first == std::string::npos ? "" : printable.substr(first, last - first + 1);
}

std::optional<FastrakStatus> read_status(std::string_view text) {
    const bool framed = text[0] == '2' && text[1] >= '1' && text[1] <= '4' && text[2] == 'S' &&
                        text.ends_with("\r\n");
    const auto flags = hexadecimal(text.substr(3, 3));
    if (!framed || !flags) {
        return std::nullopt;
    }
    return FastrakStatus{.binary = (*flags & 1U) != 0,
                         .centimetres = (*flags & 2U) != 0,
                         .compensation = (*flags & 4U) != 0,
                         .continuous = (*flags & 8U) != 0,
                         .error = text[6],
                         .version = trimmed(text.substr(15, 6)),
                         .identification = trimmed(text.substr(21, 32))};
}

/// The text behind a reply's head, '2' station letter, up to the line's end; the last one there is.
std::optional<std::string_view> find_reply(std::string_view bytes, char station, char letter) {
    std::optional<std::string_view> found;
    for (std::size_t at = 0; at + 3 <= bytes.size(); ++at) {
        const bool head = bytes[at] == '2' && bytes[at + 2] == letter &&
                          (station == 0 || bytes[at + 1] == station);
        const auto end = head ? bytes.find("\r\n", at) : std::string_view::npos;
        if (end != std::string_view::npos) {
            found = bytes.substr(at + 3, end - at - 3);
        }
    }
    return found;
}

const char* reason(std::string_view code) {
    if (code.starts_with("-99")) {
        return "unknown command";
    }
    if (code.starts_with("-1")) {
        return "something is missing";
    }
    return code.starts_with("-2")   ? "expected a number"
           : code.starts_with("-3") ? "out of range"
                                    : "refused";
}

}  // namespace

std::optional<FastrakStatus> find_status(std::string_view bytes) {
    for (std::size_t at = 0; at + kFastrakStatusBytes <= bytes.size(); ++at) {
        if (auto status = read_status(bytes.substr(at, kFastrakStatusBytes))) {
            return status;
        }
    }
    return std::nullopt;
}

std::optional<std::array<bool, kFastrakStations>> find_stations(std::string_view bytes) {
    const auto reply = find_reply(bytes, 0, 'l');
    if (!reply || reply->size() != kFastrakStations ||
        reply->find_first_not_of("01") != std::string_view::npos) {
        return std::nullopt;
    }
    std::array<bool, kFastrakStations> on{};
    std::transform(reply->begin(), reply->end(), on.begin(), [](char c) { return c == '1'; });
    return on;
}

std::optional<std::vector<int>> find_output_list(std::string_view bytes, int station) {
    const auto reply = find_reply(bytes, static_cast<char>('0' + station), 'O');
    if (!reply) {
        return std::nullopt;
    }
    std::vector<int> items;
    const char* at = reply->data();
    const char* const end = at + reply->size();
    while (at != end) {
        int item = 0;
        const auto read = std::from_chars(at, end, item);
        if (read.ec == std::errc()) {
            items.push_back(item);
            at = read.ptr;
        } else if (*at == ' ' || *at == ',') {
            ++at;
        } else {
            return std::nullopt;
        }
    }
    return items;
}

std::optional<std::string> find_complaint(std::string_view bytes) {
    const auto first = bytes.find(kComplaint);
    const auto start = first + kComplaint.size();
    const auto second = first == std::string_view::npos ? first : bytes.find(kComplaint, start);
    if (second == std::string_view::npos) {
        return std::nullopt;
    }
    const auto code = bytes.find("EC", second);
    const auto number = code == std::string_view::npos ? "" : bytes.substr(code + 2, 3);
    return trimmed(bytes.substr(start, second - start)) + ": " + reason(number);
}

}  // namespace percussionist::motion
