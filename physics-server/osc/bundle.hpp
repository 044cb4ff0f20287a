// Putting values into liblo's messages and bundles. For osc/ alone: liblo shows here.
//
// Pure functions; any thread.
#pragma once

#include <lo/lo.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "osc/wire.hpp"

namespace percussionist::osc {

/// NTP time, what OSC tags carry, counts from 1900.
inline constexpr double kSecondsTo1970 = 2208988800.0;

inline lo_timetag time_tag(double wall) {
    const double whole = std::floor(wall);
    return {static_cast<std::uint32_t>(whole + kSecondsTo1970),
            static_cast<std::uint32_t>((wall - whole) * 4294967296.0)};
}

struct BundleFree {
    void operator()(void* bundle) const { lo_bundle_free_recursive(bundle); }
};
using Bundle = std::unique_ptr<std::remove_pointer_t<lo_bundle>, BundleFree>;

inline Bundle make_bundle(double wall) {
    return Bundle(lo_bundle_new(time_tag(wall)));
}

inline Packet serialise(const Bundle& bundle) {
    std::size_t size = lo_bundle_length(bundle.get());
    Packet packet(size);
    lo_bundle_serialise(bundle.get(), packet.data(), &size);
    return packet;
}

/// Takes the message.
inline Packet serialise(const std::string& address, lo_message message) {
    std::size_t size = lo_message_length(message, address.c_str());
    Packet packet(size);
    lo_message_serialise(message, address.c_str(), packet.data(), &size);
    lo_message_free(message);
    return packet;
}

inline void add(lo_message message, float value) {
    lo_message_add_float(message, value);
}
inline void add(lo_message message, double value) {
    lo_message_add_double(message, value);
}
inline void add(lo_message message, std::int32_t value) {
    lo_message_add_int32(message, value);
}
inline void add(lo_message message, const std::string& value) {
    lo_message_add_string(message, value.c_str());
}

template <class... Values>
lo_message make_message(const Values&... values) {
    lo_message message = lo_message_new();
    (add(message, values), ...);
    return message;
}

template <class Number>
lo_message make_message_of(std::span<const Argument> arguments) {
    lo_message message = lo_message_new();
    for (const Argument& argument : arguments) {
        if (const auto* text = std::get_if<std::string>(&argument)) {
            add(message, *text);
        } else {
            add(message, static_cast<Number>(std::get<double>(argument)));
        }
    }
    return message;
}

template <class... Values>
Packet one_message(double tag, const char* address, const Values&... values) {
    Bundle bundle = make_bundle(tag);
    lo_bundle_add_message(bundle.get(), address, make_message(values...));
    return serialise(bundle);
}

}  // namespace percussionist::osc
