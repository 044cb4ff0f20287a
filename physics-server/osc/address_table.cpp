#include "osc/address_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>

namespace percussionist::osc {

namespace {

double number(std::span<const Argument> arguments, std::size_t index) {
    return std::get<double>(arguments[index]);
}

std::string text(std::span<const Argument> arguments, std::size_t index,
                 const std::string& otherwise) {
    return index < arguments.size() ? std::get<std::string>(arguments[index]) : otherwise;
}

/// The words from `first` on as one line.
std::string line(std::span<const Argument> arguments, std::size_t first) {
    std::string text;
    for (const Argument& a : arguments.subspan(first)) {
        const auto* number = std::get_if<double>(&a);
        text += number != nullptr ? fmt::format("{} ", *number) : std::get<std::string>(a) + ' ';
    }
    return text;
}

std::string port_text(double port) {
    return std::to_string(static_cast<int>(port));
}

Feed feed(const std::string& name) {
    if (name == "pose") return Feed::pose;
    return name == "all" ? Feed::all : Feed::sound;
}

constexpr double kFloatGrain = 1e-7;
/// /play and /stop come first, then the manner of playing.
constexpr int kBeforeManner = 2;

constexpr Parameter kPort{"PORT", "", false, true, 1, 65535};
constexpr Parameter kFeed{"FEED", "", true, false, 0, 0, false, "sound pose all"};
constexpr Parameter kNumber{"NUMBER", "", false, true, 1, 1e9};
constexpr Parameter kRoute{"ROUTE", "", true, true, 0, 0, true};

std::vector<Address> make_table() {
    using Arguments = std::span<const Argument>;
    return {
        {"/play",
         "play the score from its beginning",
         {},
         [](Arguments) -> Command { return Play{}; }},
        {"/stop",
         "stop playing and let the sticks rest",
         {},
         [](Arguments) -> Command { return Stop{}; }},
        {"/score",
         "load FILE of the server's score folder, or built-in: a Standard MIDI File, MusicXML, or "
         "a recording of sound; for one drum also a motion: .bvh, or .csv of sticks",
         {{"FILE", "", true, true}},
         [](Arguments a) -> Command { return LoadScore{text(a, 0, "")}; }},
        {"/subscribe",
         "send events to PORT of the asker or of HOST; FEED is sound (contacts, clock, status), "
         "pose or all",
         {kPort, kFeed, {"HOST", "", true, false}},
         [](Arguments a) -> Command {
             return Subscribe{{text(a, 2, ""), port_text(number(a, 0))}, feed(text(a, 1, "sound"))};
         }},
        {"/unsubscribe",
         "send no more to PORT of the asker or of HOST",
         {kPort, {"HOST", "", true, false}},
         [](Arguments a) -> Command {
             return Unsubscribe{{text(a, 1, ""), port_text(number(a, 0))}};
         }},
        {"/route/add",
         "send an event on: EVENT to HOST:PORT ADDRESS FIELD... when FIELD LEAST MOST; answered by "
         "its number",
         {kRoute},
         [](Arguments a) -> Command { return AddRoute{line(a, 0)}; }},
        {"/route/change",
         "another route in place of one",
         {kNumber, kRoute},
         [](Arguments a) -> Command {
             return ChangeRoute{static_cast<int>(number(a, 0)), line(a, 1)};
         }},
        {"/route/remove",
         "no longer this route",
         {kNumber},
         [](Arguments a) -> Command { return RemoveRoute{static_cast<int>(number(a, 0))}; }},
        {"/route/list",
         "answered by the routes, a /route each: number and line",
         {},
         [](Arguments) -> Command { return ListRoutes{}; }},
        {"/route/save",
         "write the routes to FILE.routes in the server's folder",
         {{"FILE", "", true, true}},
         [](Arguments a) -> Command { return SaveRoutes{text(a, 0, "")}; }},
        {"/record",
         "record what is played to FILE.recording in the server's folder; without FILE no longer",
         {{"FILE", "", true, false}},
         [](Arguments a) -> Command { return Record{text(a, 0, "")}; }},
        {"/ping",
         "answered by /pong to the asker",
         {},
         [](Arguments) -> Command { return Ping{}; }},
        {"/describe",
         "answered by this table, a /description each",
         {},
         [](Arguments) -> Command { return Describe{}; }},
    };
}

/// "sound, pose or all"
std::string listed(const std::string& choices) {
    std::istringstream words(choices);
    std::vector<std::string> each{std::istream_iterator<std::string>(words), {}};
    const std::string last = each.back();
    each.pop_back();
    return fmt::format("{} or {}", fmt::join(each, ", "), last);
}

bool is_choice(const std::string& choices, const std::string& word) {
    std::istringstream words(choices);
    return std::find(std::istream_iterator<std::string>(words), {}, word) !=
           std::istream_iterator<std::string>();
}

/// Short enough for an answer of one packet.
std::string quoted(const std::string& text) {
    constexpr std::size_t kMost = 80;
    return '\'' + text.substr(0, kMost) + (text.size() > kMost ? "..." : "") + '\'';
}

std::size_t most_letters(const Parameter& p) {
    constexpr std::size_t kOtherwise = 255;
    return p.most > 0.0 ? static_cast<std::size_t>(p.most) : kOtherwise;
}

std::string wrong(const Parameter& p, const Argument& got) {
    const std::string shown = std::holds_alternative<double>(got)
                                  ? fmt::format("{:g}", std::get<double>(got))
                                  : quoted(std::get<std::string>(got));
    if (p.text) {
        const std::string expected =
            *p.choices != '\0' ? listed(p.choices)
                               : fmt::format("a text of at most {} letters", most_letters(p));
        return fmt::format("{}: expected {}, got {}", p.name, expected, shown);
    }
    return fmt::format("{}: expected a number from {:g} to {:g}{}{}, got {}", p.name, p.least,
                       p.most, *p.unit != '\0' ? " " : "", p.unit, shown);
}

/// A bound that came as a float may be a little beyond itself.
double settled(const Parameter& p, double value) {
    const auto is = [value](double bound) {
        return std::abs(value - bound) <= kFloatGrain * std::abs(bound);
    };
    return is(p.least) ? p.least : is(p.most) ? p.most : value;
}

std::vector<Argument> settled(const Address& address, std::span<const Argument> arguments) {
    std::vector<Argument> all(arguments.begin(), arguments.end());
    for (std::size_t i = 0; i < std::min(all.size(), address.parameters.size()); ++i) {
        const Parameter& p = address.parameters[i];
        auto* value = std::get_if<double>(&all[i]);
        if (value != nullptr && !p.text) *value = settled(p, *value);
    }
    return all;
}

bool fits(const Parameter& p, const Argument& got) {
    if (p.text) {
        const auto* word = std::get_if<std::string>(&got);
        if (word == nullptr) return false;
        return *p.choices == '\0' ? word->size() <= most_letters(p) : is_choice(p.choices, *word);
    }
    const double* value = std::get_if<double>(&got);
    return value != nullptr && *value >= p.least && *value <= p.most;
}

/// The first thing wrong with the arguments; empty if nothing is.
std::string fault(const Address& address, std::span<const Argument> arguments) {
    std::size_t required = 0;
    for (const Parameter& p : address.parameters) required += p.required ? 1 : 0;
    const bool open = !address.parameters.empty() && address.parameters.back().rest;
    if (arguments.size() < required || (!open && arguments.size() > address.parameters.size())) {
        return fmt::format("expected {}, got {} argument{}", usage(address), arguments.size(),
                           arguments.size() == 1 ? "" : "s");
    }
    for (std::size_t i = 0; i < std::min(arguments.size(), address.parameters.size()); ++i) {
        if (address.parameters[i].rest) break;
        if (!fits(address.parameters[i], arguments[i])) {
            return wrong(address.parameters[i], arguments[i]);
        }
    }
    return {};
}

}  // namespace

const std::vector<Address>& address_table() {
    static const std::vector<Address> table = [] {
        std::vector<Address> all = make_table();
        std::vector<Address> manner = manner_addresses();
        const std::vector<Address> kit = kit_addresses();
        manner.insert(manner.end(), kit.begin(), kit.end());
        all.insert(all.begin() + kBeforeManner, manner.begin(), manner.end());
        return all;
    }();
    return table;
}

std::string usage(const Address& address) {
    std::string line = address.path;
    for (const Parameter& p : address.parameters) {
        line += p.required ? fmt::format(" {}", p.name) : fmt::format(" [{}]", p.name);
        if (p.rest) line += "...";
        if (*p.choices != '\0') line += fmt::format(" ({})", listed(p.choices));
        if (!p.text && p.most > p.least) {
            line += fmt::format(" ({:g} to {:g}{}{})", p.least, p.most, *p.unit != '\0' ? " " : "",
                                p.unit);
        }
    }
    return line;
}

std::variant<Command, Refusal> understand(const std::string& path,
                                          std::span<const Argument> arguments) {
    for (const Address& address : address_table()) {
        if (path != address.path) continue;
        const std::vector<Argument> given = settled(address, arguments);
        const std::string reason = fault(address, given);
        if (!reason.empty()) return Refusal{path, reason};
        return address.make(given);
    }
    constexpr std::size_t kLongest = 80;
    return Refusal{path.substr(0, kLongest), "no such address; /describe lists them"};
}

}  // namespace percussionist::osc
