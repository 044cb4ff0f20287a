#include "tracker/fastrak_command.hpp"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace percussionist::tracker {

namespace {

constexpr std::string_view kAtOnce = "PCcFfUuSDdTW\x0b\x11\x13\x19";  // ^K ^Q ^S ^Y at the end
constexpr std::string_view kWithParameters = "OlARBbGHINrQVeoxvy";
constexpr std::string_view kActAlways = "\x11\x13\x19";

using Result = std::variant<FastrakCommand, RefusedCommand>;

/// "1,-2.5,,3" -> 1, -2.5, nothing, 3.
bool read_values(std::string_view text, std::vector<std::optional<double>>& values) {
    while (!text.empty() || !values.empty()) {
        const auto comma = text.find(',');
        std::string_view field = text.substr(0, comma);
        while (!field.empty() && (field.front() == ' ' || field.front() == '+')) {
            field.remove_prefix(1);
        }
        while (!field.empty() && field.back() == ' ') {
            field.remove_suffix(1);
        }
        if (field.empty()) {
            values.emplace_back();
        } else {
            double value = 0.0;
            const auto end = std::from_chars(field.data(), field.data() + field.size(), value);
            if (end.ec != std::errc() || end.ptr != field.data() + field.size() ||
                !std::isfinite(value)) {
                return false;
            }
            values.emplace_back(value);
        }
        if (comma == std::string_view::npos) {
            return true;
        }
        text.remove_prefix(comma + 1);
    }
    return true;
}

Result read_command(const std::string& text) {
    FastrakCommand command{.letter = text[0], .at_once = false, .text = text, .values = {}};
    const std::string_view parameters = std::string_view(text).substr(1);
    if (!read_values(parameters, command.values)) {
        return RefusedCommand{text, Refusal::kNotANumber};
    }
    return command;
}

}  // namespace

std::optional<Result> FastrakCommandReader::receive(std::uint8_t byte) {
    const char c = static_cast<char>(byte);
    if (kActAlways.find(c) != std::string_view::npos ||
        (pending_.empty() && kAtOnce.find(c) != std::string_view::npos)) {
        return FastrakCommand{
            .letter = c, .at_once = true, .text = std::string(1, c), .values = {}};
    }
    if (c == '\n' || (pending_.empty() && (c == '\r' || c == ' '))) {
        return std::nullopt;
    }
    if (pending_.empty() && kWithParameters.find(c) == std::string_view::npos) {
        return RefusedCommand{std::string(1, c), Refusal::kUnknown};
    }
    if (c == '\r') {
        const std::string text = std::exchange(pending_, {});
        return read_command(text);
    }
    pending_ += c;
    if (pending_.size() > motion::kFastrakMostBytes) {
        return RefusedCommand{std::exchange(pending_, {}).substr(0, 16), Refusal::kOutOfRange};
    }
    return std::nullopt;
}

}  // namespace percussionist::tracker
