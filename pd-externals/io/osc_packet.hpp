// OSC packets: bytes in, values out, and back. No packet can do harm: all of its bytes are checked
// before oscpack takes it apart.
//
// What becomes of the types of OSC: i f d h and t (seconds since 1900) are numbers, T is 1, F is 0,
// s and S are words, c is a word of one letter, N the word nil, I the word inf. b is its size and
// then its bytes as numbers, r one number, m four. Arrays are their elements.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace percussionist::io {

using Bytes = std::vector<std::uint8_t>;
using OscValue = std::variant<double, std::string>;

struct OscMessage {
    std::string address;
    std::vector<OscValue> arguments;
};

/// Seconds since 1900 in units of 2^-32 s.
using TimeTag = std::uint64_t;
constexpr TimeTag kImmediately = 1;
constexpr double kTagsPerSecond = 4294967296.0;

/// From `from` to `to`; right across the year 2036 too, where tags begin again at 0.
inline double seconds_between(TimeTag from, TimeTag to) {
    return static_cast<double>(static_cast<std::int64_t>(to - from)) / kTagsPerSecond;
}

/// Messages of one time tag, in their order.
struct OscBundle {
    TimeTag tag = kImmediately;
    std::vector<OscMessage> messages;
};

struct OscPacket {
    TimeTag tag = kImmediately;      ///< of the outermost bundle
    std::vector<OscBundle> bundles;  ///< in their order; nested ones with tags of their own
};

/// what(): "byte 12: expected ..."
struct MalformedOsc : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws MalformedOsc.
OscPacket read_osc(std::span<const std::uint8_t> bytes);

/// A message: numbers as f, words as s; those in `as_integers` as i. Throws std::invalid_argument
/// if it does not fit a packet.
Bytes write_osc(const std::string& address, std::span<const OscValue> arguments,
                bool as_integers = false);

}  // namespace percussionist::io
