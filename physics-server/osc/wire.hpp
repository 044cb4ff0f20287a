// Between values and OSC packets, on liblo's messages and bundles.
//
// Pure functions over bytes; any thread. decode() takes any bytes whatever without harm.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "osc/address_table.hpp"
#include "osc/outgoing.hpp"

namespace percussionist::osc {

using Packet = std::vector<char>;

/// A contact, and behind it those before it (newest first), each in a bundle with its own time tag.
Packet encode(const ContactMessage& contact, std::span<const ContactMessage> earlier,
              double lookahead);
Packet encode(const PoseMessage& pose, double lookahead);
Packet encode(const SceneMessage& scene, double lookahead);
Packet encode(const StatusMessage& status, int subscribers, double lookahead);
Packet encode(const StateMessage& state, double lookahead);
Packet encode(const StartedMessage& started, double lookahead);
Packet encode(const FinishedMessage& finished, double lookahead);
Packet encode(const DroppedMessage& dropped);
/// A route's message, to be acted on at wall + lookahead; numbers as floats.
Packet encode_routed(const std::string& address, std::span<const Argument> arguments, double tag);
/// The instant of sending, announced with the lookahead: what a receiver sets its clock by.
Packet encode_clock(double wall, double lookahead);
/// A single message, to be acted on at once: of texts, or of numbers (floats) and texts.
Packet encode_text(const std::string& address, std::span<const std::string> texts);
Packet encode_message(const std::string& address, std::span<const Argument> arguments);
/// The same with numbers as doubles, so that decode() gives back what went in.
Packet encode_exactly(const std::string& address, std::span<const Argument> arguments);

/// What a kit's drummer tells, see kit_wire.cpp.
Packet encode(const ObjectsMessage& objects, double lookahead);
Packet encode(const KitMessage& kit, double lookahead);
Packet encode(const TickMessage& tick, double lookahead);
Packet encode(const NotedMessage& noted, double lookahead);

/// Calls `heard` for each message of a packet, bundled or not. False if it was not OSC.
bool decode(std::span<const char> bytes,
            const std::function<void(const std::string& path, std::span<const Argument>)>& heard);

/// The same with the tag of the innermost bundle, as wall clock [s]; none: at once.
using TaggedHeard = std::function<void(const std::string& path, std::span<const Argument>,
                                       std::optional<double> tag)>;
bool decode_tagged(std::span<const char> bytes, const TaggedHeard& heard);

}  // namespace percussionist::osc
