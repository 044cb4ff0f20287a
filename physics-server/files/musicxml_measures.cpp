#include "files/musicxml_measures.hpp"

#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

namespace percussionist::files {

namespace {

struct Barline {
    bool repeat_from = false;
    int repeat_times = 0;  ///< 0: no repeat back from here
    std::string ending;    ///< "1, 2": begins here
    bool ending_stops = false;
};

Barline barline_of(const pugi::xml_node& measure) {
    Barline b;
    for (const pugi::xml_node& line : measure.children("barline")) {
        const pugi::xml_node repeat = line.child("repeat");
        const char* direction = repeat.attribute("direction").as_string();
        if (std::strcmp(direction, "forward") == 0) b.repeat_from = true;
        if (std::strcmp(direction, "backward") == 0) {
            b.repeat_times = repeat.attribute("times").as_int(2);
        }
        const pugi::xml_node ending = line.child("ending");
        if (std::strcmp(ending.attribute("type").as_string(), "start") == 0) {
            b.ending = ending.attribute("number").as_string();
        } else if (ending) {
            b.ending_stops = true;
        }
    }
    return b;
}

/// Whether "1, 2" names this pass.
bool names(const std::string& ending, int pass) {
    const char* at = ending.c_str();
    while (*at != '\0') {
        char* end = nullptr;
        const long number = std::strtol(at, &end, 10);
        if (end == at) {
            ++at;
            continue;
        }
        if (number == pass) return true;
        at = end;
    }
    return false;
}

}  // namespace

std::vector<std::size_t> playing_order(const std::vector<pugi::xml_node>& measures,
                                       std::size_t most) {
    std::vector<std::size_t> order;
    std::map<std::size_t, int> passes;  // by the measure a repeat goes back from
    std::size_t from = 0;
    int pass = 1;
    bool skipping = false;
    for (std::size_t i = 0; i < measures.size() && order.size() < most;) {
        const Barline b = barline_of(measures[i]);
        if (b.repeat_from && from != i) {
            from = i;
            pass = 1;
        }
        if (!b.ending.empty()) skipping = !names(b.ending, pass);
        if (!skipping) order.push_back(i);
        const bool back = b.repeat_times > 0 && !skipping;
        if (b.ending_stops || b.repeat_times > 0) skipping = false;
        if (back && ++passes[i] < b.repeat_times) {
            i = from;
            ++pass;
        } else {
            if (back) {
                from = i + 1;
                pass = 1;
            }
            ++i;
        }
    }
    return order;
}

}  // namespace percussionist::files
