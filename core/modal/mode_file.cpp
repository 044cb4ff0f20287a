#include "core/modal/mode_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace percussionist::modal {

namespace {

constexpr std::string_view kFirstLine = "percussionist modes 1";

void append(std::string& text, double number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    text.append(" ").append(digits.data(), end);
}

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
    throw std::invalid_argument("line " + std::to_string(line) + ": " + what);
}

std::string_view trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_space(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// Cuts the first word off.
std::string_view next_word(std::string_view& rest) {
    const auto end = std::min(rest.find_first_of(" \t"), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest = trimmed(rest.substr(end));
    return word;
}

std::vector<double> numbers(std::string_view rest, std::size_t line) {
    std::vector<double> values;
    while (!rest.empty()) {
        const std::string_view word = next_word(rest);
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
            refuse(line, "expected a number, got '" + std::string(word.substr(0, 40)) + "'");
        }
        values.push_back(value);
    }
    return values;
}

GivenMode mode_of(const std::vector<double>& values, std::size_t line) {
    if (values.size() < 4) {
        refuse(line, "expected mode FREQUENCY T60 DIAMETERS WEIGHT...");
    }
    if (values[2] != std::floor(values[2]) || std::abs(values[2]) > 1e6) {
        refuse(line, "expected a whole number of diameters");
    }
    return {.frequency = values[0],
            .t60 = values[1],
            .diameters = static_cast<int>(values[2]),
            .weights = {values.begin() + 3, values.end()}};
}

void take_line(GivenModes& given, std::string_view text, std::size_t line) {
    const std::string_view key = next_word(text);
    if (key == "name") {
        given.name = text;
    } else if (key == "origin") {
        given.origin = text;
    } else if (key == "places") {
        given.places = numbers(text, line);
    } else if (key == "radius") {
        const auto values = numbers(text, line);
        if (values.size() != 1) {
            refuse(line, "expected radius METRES");
        }
        given.radius = values[0];
    } else if (key == "mode") {
        if (given.modes.size() == 8192) {
            refuse(line, "expected at most 8192 modes");
        }
        given.modes.push_back(mode_of(numbers(text, line), line));
    } else if (key == "heard") {
        const auto values = numbers(text, line);
        if (values.size() != 1 || given.modes.empty()) {
            refuse(line, "expected heard WEIGHT below its mode");
        }
        given.modes.back().heard = values[0];
    } else {
        refuse(line, "expected name, origin, radius, places, mode or heard, got '" +
                         std::string(key.substr(0, 40)) + "'");
    }
}

}  // namespace

std::string write_modes(const GivenModes& given) {
    std::string text =
        std::string(kFirstLine) + "\nname " + given.name + "\norigin " + given.origin + "\nradius";
    append(text, given.radius);
    text += "\nplaces";
    std::for_each(given.places.begin(), given.places.end(), [&](double x) { append(text, x); });
    for (const auto& mode : given.modes) {
        text += "\nmode";
        append(text, mode.frequency);
        append(text, mode.t60);
        append(text, mode.diameters);
        std::for_each(mode.weights.begin(), mode.weights.end(), [&](double x) { append(text, x); });
        if (mode.heard != 0.0) {
            text += "\nheard";
            append(text, mode.heard);
        }
    }
    return text + "\n";
}

GivenModes parse_modes(std::string_view text) {
    GivenModes given;
    std::size_t line = 0;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view content = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (++line == 1) {
            if (content != kFirstLine) {
                refuse(1, "expected '" + std::string(kFirstLine) + "'");
            }
        } else if (!content.empty() && content.front() != '#') {
            take_line(given, content, line);
        }
    }
    if (line == 0) {
        refuse(1, "expected '" + std::string(kFirstLine) + "'");
    }
    check(given);
    return given;
}

}  // namespace percussionist::modal
