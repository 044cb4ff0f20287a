#include "pdx/arguments.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace percussionist::pdx {

namespace {

std::string to_string(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

bool fits(const Argument& argument, const Atom& atom) {
    switch (argument.kind) {
        case Argument::Kind::kAnything:
            return true;
        case Argument::Kind::kWord:
            return !is_number(atom);
        case Argument::Kind::kNumber:
            break;
    }
    if (!is_number(atom)) {
        return false;
    }
    const double value = std::get<double>(atom);
    return std::isfinite(value) && value <= argument.high &&
           (argument.low_excluded ? value > argument.low : value >= argument.low);
}

[[noreturn]] void refuse(const Argument& argument, const std::string& message,
                         const std::string& got) {
    throw std::invalid_argument((argument.name == message ? "" : argument.name + ": ") +
                                "expected " + argument.expected() + ", got " + got);
}

}  // namespace

std::string to_string(const Atom& atom) {
    return is_number(atom) ? to_string(std::get<double>(atom)) : std::get<const char*>(atom);
}

Argument number(std::string name, std::string unit) {
    Argument argument;
    argument.name = std::move(name);
    argument.unit = std::move(unit);
    return argument;
}

Argument word(std::string name) {
    Argument argument = number(std::move(name));
    argument.kind = Argument::Kind::kWord;
    return argument;
}

Argument anything(std::string name) {
    Argument argument = number(std::move(name)).or_none();
    argument.kind = Argument::Kind::kAnything;
    return argument;
}

Argument Argument::above(double limit) const {
    Argument copy = from(limit);
    copy.low_excluded = true;
    return copy;
}

Argument Argument::from(double limit) const {
    Argument copy = *this;
    copy.low = limit;
    return copy;
}

Argument Argument::to(double limit) const {
    Argument copy = *this;
    copy.high = limit;
    return copy;
}

Argument Argument::by_default(double value) const {
    Argument copy = *this;
    copy.optional = true;
    copy.standard = value;
    return copy;
}

Argument Argument::by_default_word(const char* value) const {
    Argument copy = by_default(0.0);
    copy.standard = value;
    return copy;
}

Argument Argument::or_none() const {
    return by_default(std::nan(""));
}

std::string Argument::expected() const {
    if (kind != Kind::kNumber) {
        return kind == Kind::kWord ? "a word" : "anything";
    }
    std::string text = "a number";
    if (std::isfinite(low) && std::isfinite(high) && !low_excluded) {
        text += " from " + to_string(low) + " to " + to_string(high);
    } else {
        if (std::isfinite(low)) {
            text +=
                low_excluded ? " above " + to_string(low) : " of " + to_string(low) + " or more";
        }
        if (std::isfinite(high)) {
            text += std::string(std::isfinite(low) ? "," : "") + " at most " + to_string(high);
        }
    }
    return unit.empty() ? text : text + " [" + unit + "]";
}

Arguments check(std::span<const Argument> expected, std::span<const Atom> given,
                const std::string& message) {
    const bool open = !expected.empty() && expected.back().kind == Argument::Kind::kAnything;
    if (!open && given.size() > expected.size()) {
        const std::string most = expected.empty()
                                     ? "no arguments"
                                     : "at most " + std::to_string(expected.size()) + " argument" +
                                           (expected.size() == 1 ? "" : "s");
        throw std::invalid_argument("expected " + most + ", got " + std::to_string(given.size()));
    }
    std::vector<Atom> atoms(given.begin(), given.end());
    for (std::size_t i = 0; i < std::min(given.size(), expected.size()); ++i) {
        if (!fits(expected[i], given[i])) {
            refuse(expected[i], message, to_string(given[i]));
        }
    }
    for (std::size_t i = given.size(); i < expected.size(); ++i) {
        if (!expected[i].optional) {
            refuse(expected[i], message, "nothing");
        }
        if (is_number(expected[i].standard) && std::isnan(std::get<double>(expected[i].standard))) {
            break;
        }
        atoms.push_back(expected[i].standard);
    }
    return {std::move(atoms), given.size()};
}

std::string usage(const std::string& message, std::span<const Argument> arguments) {
    std::string text = message;
    for (const auto& argument : arguments) {
        std::string name = argument.name;
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        name += argument.unit.empty() ? "" : " [" + argument.unit + "]";
        text += argument.optional ? " (" + name + ")" : " " + name;
    }
    return text;
}

}  // namespace percussionist::pdx
