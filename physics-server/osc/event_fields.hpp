// What can be told of each kind of event, by name: the one table of fields, from which routes
// choose.
//
// Pure values; any thread.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "osc/outgoing.hpp"

namespace percussionist::osc {

enum class EventKind { contact, strike, pose, status };

struct Field {
    const char* name;
    const char* unit;  ///< "" where there is none
    const char* description;
};

/// A message as an event: its values stand in the order of fields(kind).
struct Event {
    EventKind kind = EventKind::contact;
    double wall = 0.0;  ///< when it happened [s]
    std::string body;   ///< of a pose: whose
    std::vector<double> values;
};

std::span<const Field> fields(EventKind kind);
const char* name(EventKind kind);
std::optional<EventKind> event_kind(const std::string& name);
/// Its place in fields(kind), or nothing.
std::optional<std::size_t> field_index(EventKind kind, const std::string& name);

Event event_of(const ContactMessage& contact);
Event event_of(const StrikeMessage& strike);
Event event_of(const BodyPose& pose, double wall);
Event event_of(const StatusMessage& status);

}  // namespace percussionist::osc
