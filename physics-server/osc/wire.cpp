#include "osc/wire.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "osc/bundle.hpp"

namespace percussionist::osc {

namespace {

Bundle contact_bundle(const ContactMessage& c, double lookahead) {
    Bundle bundle = make_bundle(c.wall + lookahead);
    const float r = std::hypot(c.place[0], c.place[1]);
    const float theta = std::atan2(c.place[1], c.place[0]);
    lo_message message = make_message(c.sequence, c.hand, c.drum, c.stroke, c.instant, c.place[0],
                                      c.place[1], r, theta, c.velocity[0], c.velocity[1],
                                      c.velocity[2], c.force[0], c.force[1], c.force[2], c.impulse,
                                      c.duration, c.mass, static_cast<std::int32_t>(c.recontact));
    if (c.event >= 0) {
        add(message, c.event);
        add(message, c.event_name);
        add(message, c.object_name);
    }
    lo_bundle_add_message(bundle.get(), "/contact", message);
    return bundle;
}

/// OSC aligns to four bytes, liblo's union wants eight: values are copied out.
template <class Value>
double number(const lo_arg* at) {
    Value value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

/// The value of one argument; numbers of all types become double.
Argument argument(char type, const lo_arg* value) {
    switch (type) {
        case LO_INT32:
            return number<std::int32_t>(value);
        case LO_INT64:
            return number<std::int64_t>(value);
        case LO_FLOAT:
            return number<float>(value);
        case LO_DOUBLE:
            return number<double>(value);
        case LO_STRING:
        case LO_SYMBOL:
            return std::string(reinterpret_cast<const char*>(value));
        case LO_TRUE:
            return 1.0;
        case LO_FALSE:
            return 0.0;
        default:
            return std::string(1, type);
    }
}

using Heard = std::function<void(const std::string&, std::span<const Argument>)>;

/// Of a bundle, at eight bytes from its beginning; 1 is "at once".
std::optional<double> tag_of(std::span<const char> bundle) {
    std::array<std::uint64_t, 2> words{};
    for (std::size_t i = 0; i < 8; ++i) {
        words[i / 4] = words[i / 4] << 8 | static_cast<unsigned char>(bundle[8 + i]);
    }
    if (words[0] == 0) return std::nullopt;
    return static_cast<double>(words[0]) - kSecondsTo1970 +
           static_cast<double>(words[1]) / 4294967296.0;
}

bool decode_message(std::span<const char> bytes, const TaggedHeard& heard,
                    std::optional<double> tag) {
    // liblo wants a terminated address before it looks at anything else.
    if (bytes.empty() || bytes[0] != '/') return false;
    if (std::memchr(bytes.data(), '\0', bytes.size()) == nullptr) return false;
    std::vector<char> copy(bytes.begin(), bytes.end());
    int error = 0;
    lo_message message = lo_message_deserialise(copy.data(), copy.size(), &error);
    if (message == nullptr) return false;
    std::vector<Argument> arguments;
    const char* types = lo_message_get_types(message);
    lo_arg** values = lo_message_get_argv(message);
    for (int i = 0; i < lo_message_get_argc(message); ++i) {
        arguments.push_back(argument(types[i], values[i]));
    }
    heard(copy.data(), arguments, tag);
    lo_message_free(message);
    return true;
}

bool decode_element(std::span<const char> bytes, const TaggedHeard& heard, int depth,
                    std::optional<double> tag) {
    constexpr int kDeepest = 4;
    constexpr std::size_t kHeader = 16;
    const bool bundle = bytes.size() >= 8 && std::memcmp(bytes.data(), "#bundle", 8) == 0;
    if (!bundle) return decode_message(bytes, heard, tag);
    if (depth == kDeepest || bytes.size() < kHeader) return false;
    tag = tag_of(bytes);
    bytes = bytes.subspan(kHeader);
    while (!bytes.empty()) {
        if (bytes.size() < 4) return false;
        std::size_t size = 0;
        for (int i = 0; i < 4; ++i) size = size << 8 | static_cast<unsigned char>(bytes[i]);
        bytes = bytes.subspan(4);
        if (size > bytes.size()) return false;
        if (!decode_element(bytes.first(size), heard, depth + 1, tag)) return false;
        bytes = bytes.subspan(size);
    }
    return true;
}

}  // namespace

Packet encode(const ContactMessage& contact, std::span<const ContactMessage> earlier,
              double lookahead) {
    Bundle bundle = contact_bundle(contact, lookahead);
    for (const ContactMessage& c : earlier) {
        lo_bundle_add_bundle(bundle.get(), contact_bundle(c, lookahead).release());
    }
    return serialise(bundle);
}

Packet encode(const PoseMessage& pose, double lookahead) {
    Bundle bundle = make_bundle(pose.wall + lookahead);
    for (const BodyPose& b : pose.bodies) {
        lo_bundle_add_message(
            bundle.get(), "/pose",
            make_message(b.name, b.position[0], b.position[1], b.position[2], b.orientation[0],
                         b.orientation[1], b.orientation[2], b.orientation[3]));
    }
    return serialise(bundle);
}

Packet encode(const SceneMessage& scene, double lookahead) {
    Bundle bundle = make_bundle(scene.wall + lookahead);
    for (const BodyShape& b : scene.bodies) {
        lo_bundle_add_message(bundle.get(), "/body",
                              make_message(b.name, b.middle[0], b.middle[1], b.middle[2], b.size[0],
                                           b.size[1], b.size[2]));
    }
    for (const DrumShape& d : scene.drums) {
        lo_bundle_add_message(
            bundle.get(), "/drum",
            make_message(d.drum, d.middle[0], d.middle[1], d.middle[2], d.radius));
    }
    return serialise(bundle);
}

Packet encode(const StatusMessage& s, int subscribers, double lookahead) {
    return one_message(s.wall + lookahead, "/status", s.time, s.load, s.late_steps, s.strokes,
                       s.contacts, static_cast<std::int32_t>(subscribers));
}

Packet encode(const StateMessage& state, double lookahead) {
    Bundle bundle = make_bundle(state.wall + lookahead);
    for (const StateMessage::Item& item : state.items) {
        std::vector<Argument> arguments{item.name};
        arguments.insert(arguments.end(), item.values.begin(), item.values.end());
        lo_bundle_add_message(bundle.get(), "/state", make_message_of<float>(arguments));
    }
    return serialise(bundle);
}

Packet encode(const StartedMessage& s, double lookahead) {
    return one_message(s.wall + lookahead, "/started", s.tempo);
}

Packet encode(const FinishedMessage& f, double lookahead) {
    return one_message(f.wall + lookahead, "/finished", f.strokes, f.contacts);
}

Packet encode(const DroppedMessage& d) {
    const std::string texts[] = {d.host, d.port};
    return encode_text("/dropped", texts);
}

Packet encode_routed(const std::string& address, std::span<const Argument> arguments, double tag) {
    Bundle bundle = make_bundle(tag);
    lo_bundle_add_message(bundle.get(), address.c_str(), make_message_of<float>(arguments));
    return serialise(bundle);
}

Packet encode_clock(double wall, double lookahead) {
    return one_message(wall + lookahead, "/clock", static_cast<float>(lookahead));
}

Packet encode_text(const std::string& address, std::span<const std::string> texts) {
    const std::vector<Argument> arguments(texts.begin(), texts.end());
    return encode_message(address, arguments);
}

Packet encode_message(const std::string& address, std::span<const Argument> arguments) {
    return serialise(address, make_message_of<float>(arguments));
}

Packet encode_exactly(const std::string& address, std::span<const Argument> arguments) {
    return serialise(address, make_message_of<double>(arguments));
}

bool decode_tagged(std::span<const char> bytes, const TaggedHeard& heard) {
    return decode_element(bytes, heard, 0, std::nullopt);
}

bool decode(std::span<const char> bytes, const Heard& heard) {
    return decode_tagged(bytes, [&heard](const auto& path, const auto arguments, const auto&) {
        heard(path, arguments);
    });
}

}  // namespace percussionist::osc
