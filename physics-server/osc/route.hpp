// A route: which event goes to whom, under which address, with which arguments. One line of text:
//
//     contact to 192.168.1.5:9000 /hit velocity*0.2 r when hand 1 1 when velocity 1 10
//     pose to localhost:9001 /right_stick x y z when body right_stick
//     EVENT to HOST:PORT ADDRESS ARGUMENT... [when FIELD LEAST MOST]... [when body NAME]
//
// EVENT is contact, strike (a hand begins to prepare a stroke), pose or status; an ARGUMENT is a
// field of the event (event_fields.hpp), scaled and shifted if so written: velocity*0.2+0.1,
// r/0.33. Without arguments all fields are sent. Of a pose, `body` as an argument is the name of
// the body.
//
// Pure values; any thread. parse_route throws std::invalid_argument: the word and what was
// expected.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "osc/address_table.hpp"
#include "osc/event_fields.hpp"

namespace percussionist::osc {

struct Route {
    struct Value {
        std::optional<std::size_t> field;  ///< nothing: the body's name
        double scale = 1.0, offset = 0.0;
    };
    struct Condition {
        std::size_t field = 0;
        double least = 0.0, most = 0.0;
    };
    EventKind event = EventKind::contact;
    Peer to;
    std::string address;
    std::vector<Value> values;
    std::vector<Condition> conditions;
    std::string body;  ///< of a pose: this one alone; empty: all
};

Route parse_route(const std::string& line);
/// The line that parses to the same route.
std::string to_string(const Route& route);

/// Whether the event goes this way.
bool matches(const Route& route, const Event& event);
/// What is sent for it.
std::vector<Argument> arguments(const Route& route, const Event& event);

}  // namespace percussionist::osc
