#include "osc/event_fields.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace percussionist::osc {

namespace {

constexpr std::array kContact{
    Field{"sequence", "", "counts contacts from 0"},
    Field{"hand", "", "0 left, 1 right"},
    Field{"drum", "", "which drum"},
    Field{"stroke", "", "of the score; -1: none"},
    Field{"instant", "s", "simulated time"},
    Field{"x", "m", "place on the head"},
    Field{"y", "m", "place on the head"},
    Field{"r", "m", "distance from its middle"},
    Field{"theta", "rad", "angle of the place"},
    Field{"vx", "m/s", "of the tip just before"},
    Field{"vy", "m/s", "of the tip just before"},
    Field{"vz", "m/s", "of the tip just before"},
    Field{"velocity", "m/s", "of the tip, into the head"},
    Field{"force", "N", "peak, into the head"},
    Field{"impulse", "N s", "on the head"},
    Field{"duration", "s", "of the contact"},
    Field{"mass", "kg", "effective, of the tip"},
    Field{"recontact", "", "1: within the rest after a stroke"},
};
constexpr std::array kStrike{
    Field{"hand", "", "0 left, 1 right"},
    Field{"stroke", "", "of the score"},
    Field{"ahead", "s", "from now to the impact"},
    Field{"velocity", "m/s", "of the tip, into the head"},
    Field{"height", "m", "to which the tip is raised"},
};
constexpr std::array kPose{
    Field{"x", "m", "centre of mass"}, Field{"y", "m", "centre of mass"},
    Field{"z", "m", "centre of mass"}, Field{"qw", "", "orientation"},
    Field{"qx", "", "orientation"},    Field{"qy", "", "orientation"},
    Field{"qz", "", "orientation"},
};
constexpr std::array kStatus{
    Field{"time", "s", "simulated"},
    Field{"load", "", "computing time over simulated time"},
    Field{"late", "", "steps that came late"},
    Field{"strokes", "", "asked for"},
    Field{"contacts", "", "made"},
};
constexpr std::array<const char*, 4> kNames{"contact", "strike", "pose", "status"};

}  // namespace

std::span<const Field> fields(EventKind kind) {
    switch (kind) {
        case EventKind::contact:
            return kContact;
        case EventKind::strike:
            return kStrike;
        case EventKind::pose:
            return kPose;
        case EventKind::status:
            return kStatus;
    }
    return {};
}

const char* name(EventKind kind) {
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<EventKind> event_kind(const std::string& text) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (text == kNames[i]) return static_cast<EventKind>(i);
    }
    return std::nullopt;
}

std::optional<std::size_t> field_index(EventKind kind, const std::string& text) {
    const auto all = fields(kind);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::string_view(all[i].name) == text) return i;
    }
    return std::nullopt;
}

Event event_of(const ContactMessage& c) {
    const double x = c.place[0];
    const double y = c.place[1];
    return {EventKind::contact,
            c.wall,
            {},
            {static_cast<double>(c.sequence), static_cast<double>(c.hand),
             static_cast<double>(c.drum), static_cast<double>(c.stroke), c.instant, x, y,
             std::hypot(x, y), std::atan2(y, x), c.velocity[0], c.velocity[1], c.velocity[2],
             -c.velocity[2], -c.force[2], c.impulse, c.duration, c.mass, c.recontact ? 1.0 : 0.0}};
}

Event event_of(const StrikeMessage& s) {
    return {EventKind::strike,
            s.wall,
            {},
            {static_cast<double>(s.hand), static_cast<double>(s.stroke), s.ahead, s.velocity,
             s.height}};
}

Event event_of(const BodyPose& p, double wall) {
    return {EventKind::pose,
            wall,
            p.name,
            {p.position[0], p.position[1], p.position[2], p.orientation[0], p.orientation[1],
             p.orientation[2], p.orientation[3]}};
}

Event event_of(const StatusMessage& s) {
    return {EventKind::status,
            s.wall,
            {},
            {s.time, s.load, static_cast<double>(s.late_steps), static_cast<double>(s.strokes),
             static_cast<double>(s.contacts)}};
}

}  // namespace percussionist::osc
