#include "osc/route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace percussionist::osc {

namespace {

constexpr std::size_t kMostWords = 64;
constexpr std::size_t kLongestLine = 1000;  // so that answers fit a packet

[[noreturn]] void refuse(const std::string& expected, const std::string& got) {
    constexpr std::size_t kMost = 80;
    throw std::invalid_argument("route: expected " + expected + ", got " +
                                (got.empty() ? "nothing" : "'" + got.substr(0, kMost) + "'"));
}

/// Words of a line, one after the other; "" when there are no more.
class Words {
  public:
    explicit Words(const std::string& line) {
        if (line.size() > kLongestLine) refuse("at most 1000 characters", line.substr(0, 40));
        // In a file a comment would begin there.
        if (line.find('#') != std::string::npos) refuse("no #", line.substr(line.find('#')));
        const auto control = [](unsigned char c) { return std::iscntrl(c) && !std::isspace(c); };
        if (std::any_of(line.begin(), line.end(), control)) refuse("text", "control characters");
        std::istringstream in(line);
        for (std::string word; in >> word;) words_.push_back(word);
        if (words_.size() > kMostWords) refuse("at most 64 words", line.substr(0, 40) + "...");
    }
    [[nodiscard]] bool over() const { return at_ == words_.size(); }
    [[nodiscard]] std::string peek() const { return over() ? "" : words_[at_]; }
    std::string next() { return over() ? "" : words_[at_++]; }

  private:
    std::vector<std::string> words_;
    std::size_t at_ = 0;
};

double number(const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value)) refuse("a number", word);
    return value;
}

std::string field_names(EventKind kind) {
    std::string names;
    for (const Field& f : fields(kind)) names += (names.empty() ? "" : ", ") + std::string(f.name);
    return names;
}

std::size_t field(EventKind kind, const std::string& word) {
    const auto index = field_index(kind, word);
    if (!index)
        refuse(std::string("a field of ") + name(kind) + " (" + field_names(kind) + ")", word);
    return *index;
}

Peer peer(const std::string& word) {
    const std::size_t colon = word.rfind(':');
    if (colon == std::string::npos || colon == 0) refuse("HOST:PORT", word);
    const std::string port = word.substr(colon + 1);
    const double value = number(port);
    if (value < 1 || value > 65535 || value != std::floor(value)) {
        refuse("a port from 1 to 65535", port);
    }
    return {word.substr(0, colon), std::to_string(static_cast<int>(value))};
}

/// "velocity*0.2+0.1": a field, then factor or divisor, then what is added.
Route::Value value(EventKind kind, const std::string& word) {
    if (kind == EventKind::pose && word == "body") return {};
    const std::size_t operation = word.find_first_of("*/+-");
    Route::Value v;
    v.field = field(kind, word.substr(0, operation));
    if (operation == std::string::npos) return v;
    std::string rest = word.substr(operation);
    if (rest[0] == '*' || rest[0] == '/') {
        char* end = nullptr;
        const double factor = std::strtod(rest.c_str() + 1, &end);
        if (end == rest.c_str() + 1 || !std::isfinite(factor) ||
            (rest[0] == '/' && factor == 0.0)) {
            refuse("a factor after '" + word.substr(0, operation + 1) + "'", rest.substr(1));
        }
        v.scale = rest[0] == '*' ? factor : 1.0 / factor;
        rest = end;
    }
    if (!rest.empty()) v.offset = number(rest);
    return v;
}

void condition(Words& words, Route& route) {
    const std::string what = words.next();
    if (route.event == EventKind::pose && what == "body") {
        route.body = words.next();
        if (route.body.empty()) refuse("the name of a body", "");
        return;
    }
    Route::Condition c;
    c.field = field(route.event, what);
    c.least = number(words.next());
    c.most = number(words.next());
    route.conditions.push_back(c);
}

std::string written(EventKind kind, const Route::Value& v) {
    if (!v.field) return "body";
    std::string text = fields(kind)[*v.field].name;
    if (v.scale != 1.0) text += fmt::format("*{}", v.scale);
    if (v.offset != 0.0) text += fmt::format("{:+}", v.offset);
    return text;
}

}  // namespace

Route parse_route(const std::string& line) {
    Words words(line);
    Route route;
    const std::string event = words.next();
    const auto kind = event_kind(event);
    if (!kind) refuse("contact, strike, pose or status", event);
    route.event = *kind;
    if (const std::string to = words.next(); to != "to") refuse("'to'", to);
    route.to = peer(words.next());
    route.address = words.next();
    if (route.address.size() < 2 || route.address[0] != '/') {
        refuse("an address that begins with /", route.address);
    }
    while (!words.over() && words.peek() != "when") {
        route.values.push_back(value(route.event, words.next()));
    }
    while (!words.over()) {
        if (const std::string when = words.next(); when != "when") refuse("'when'", when);
        condition(words, route);
    }
    // As it is written into a file, a factor's digits can make it longer.
    if (to_string(route).size() > kLongestLine) refuse("a shorter route", line.substr(0, 40));
    return route;
}

std::string to_string(const Route& route) {
    std::string line = fmt::format("{} to {}:{} {}", name(route.event), route.to.host,
                                   route.to.port, route.address);
    for (const Route::Value& v : route.values) line += ' ' + written(route.event, v);
    for (const Route::Condition& c : route.conditions) {
        line += fmt::format(" when {} {} {}", fields(route.event)[c.field].name, c.least, c.most);
    }
    if (!route.body.empty()) line += " when body " + route.body;
    return line;
}

bool matches(const Route& route, const Event& event) {
    if (event.kind != route.event || (!route.body.empty() && route.body != event.body)) {
        return false;
    }
    for (const Route::Condition& c : route.conditions) {
        const double value = event.values[c.field];
        if (!(value >= c.least && value <= c.most)) return false;
    }
    return true;
}

std::vector<Argument> arguments(const Route& route, const Event& event) {
    std::vector<Argument> all;
    if (route.values.empty()) {
        if (!event.body.empty()) all.emplace_back(event.body);
        all.insert(all.end(), event.values.begin(), event.values.end());
        return all;
    }
    for (const Route::Value& v : route.values) {
        if (v.field) {
            all.emplace_back(v.scale * event.values[*v.field] + v.offset);
        } else {
            all.emplace_back(event.body);
        }
    }
    return all;
}

}  // namespace percussionist::osc
