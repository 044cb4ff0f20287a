// What the server tells: plain values, SI units; docs/osc-protocol.md says how they stand on the
// wire.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "osc/argument.hpp"

namespace percussionist::osc {

/// Instants are seconds of the server's own steady wall clock (since 1970 at its start).
struct ContactMessage {
    std::int32_t sequence = 0;
    std::int32_t hand = 0, drum = 0, stroke = -1;
    double wall = 0.0;                          ///< when it happened, wall clock [s]
    double instant = 0.0;                       ///< the same, simulated time [s]
    std::array<float, 2> place{};               ///< x y [m]
    std::array<float, 3> velocity{};            ///< [m/s]
    std::array<float, 3> force{};               ///< peak [N]
    float impulse = 0, duration = 0, mass = 0;  ///< [N s], [s], [kg]
    bool recontact = false;
    /// At a kit: `hand` is the limb, `drum` the object, and these are told behind all else.
    std::int32_t event = -1;
    std::string event_name, object_name;
};

/// A hand begins to prepare a stroke.
struct StrikeMessage {
    double wall = 0.0;  ///< now, wall clock [s]
    std::int32_t hand = 0, stroke = -1;
    float ahead = 0, velocity = 0, height = 0;  ///< to the impact [s], at it [m/s], before it [m]
};

struct BodyPose {
    std::string name;
    std::array<float, 3> position{};     ///< [m]
    std::array<float, 4> orientation{};  ///< w x y z
};

struct PoseMessage {
    double wall = 0.0;
    std::vector<BodyPose> bodies;
};

struct BodyShape {
    std::string name;
    std::array<float, 3> middle{};  ///< against its centre of mass, its own frame [m]
    std::array<float, 3> size{};    ///< along its own axes [m]
};

struct DrumShape {
    std::int32_t drum = 0;
    std::array<float, 3> middle{};  ///< of the head, world [m]
    float radius = 0.0F;            ///< [m]
};

/// What there is to see: told each second to whom poses are told.
struct SceneMessage {
    double wall = 0.0;
    std::vector<BodyShape> bodies;
    std::vector<DrumShape> drums;
};

struct StatusMessage {
    double wall = 0.0, time = 0.0;  ///< wall clock and simulated time [s]
    float load = 0.0F;              ///< computing time over simulated time
    std::int32_t late_steps = 0, strokes = 0, contacts = 0;
};

/// How it plays now: a /state each. Told when it changes and each second.
struct StateMessage {
    struct Item {
        std::string name;
        std::vector<Argument> values;
    };
    double wall = 0.0;
    std::vector<Item> items;
};

/// A score is begun: what sounds along with it begins at its time 0.
struct StartedMessage {
    double wall = 0.0;   ///< of the score's time 0 [s]
    float tempo = 1.0F;  ///< a multiple of its own
};

/// A subscriber that was dropped because it listens no more.
struct DroppedMessage {
    std::string host, port;
};

/// The score is over and has rung out.
struct FinishedMessage {
    double wall = 0.0;
    std::int32_t strokes = 0, contacts = 0;
};

/// What the objects of a kit do.
struct ObjectMotion {
    std::int32_t object = 0;
    float flash = 0;                        ///< 0 to 1
    std::array<float, 3> turn{};            ///< about its middle, world, rotation vector [rad]
    float lift = 0, pedal = 0, beater = 0;  ///< [m], 0 pressed to 1 up, [rad]
};
struct ObjectsMessage {
    double wall = 0.0;
    std::vector<ObjectMotion> objects;
};

/// What stands where, and how it is struck: told each second.
struct KitMessage {
    struct Object {
        std::string name, kind;
        std::array<float, 3> middle{};       ///< of its face, world [m]
        std::array<float, 4> orientation{};  ///< w x y z
        float radius = 0, depth = 0;         ///< [m]
    };
    struct Pedal {
        std::int32_t object = 0;
        std::array<float, 3> heel{};               ///< of the plate, world [m]
        float length = 0, direction = 0;           ///< [m], to the left [rad]
        float down = 0, up = 0;                    ///< above the floor [rad]
        std::array<float, 3> pivot{};              ///< of the beater [m]
        float beater_length = 0, beater_lean = 0;  ///< [m]; 0: none; forward, when it strikes [rad]
    };
    struct Event {
        std::string name;
        std::int32_t object = 0;
        float damping = 0;  ///< within which it ends the object's sound [s]; 0: it rings on
    };
    double wall = 0.0;
    std::vector<Object> objects;
    std::vector<Pedal> pedals;
    std::vector<Event> events;
};

/// The server's time at which this is heard, by which places of a song are told; and where it takes
/// the song to be.
struct TickMessage {
    double wall = 0.0;
    double time = 0.0, position = 0.0;  ///< [s]
};

/// What became of a live note.
struct NotedMessage {
    double wall = 0.0;
    std::int32_t key = 0, limb = -1, object = 0;  ///< -1: no limb was free
    float ahead = 0.0F;                           ///< from when it was heard to its contact [s]
};

using Outgoing =
    std::variant<ContactMessage, StrikeMessage, PoseMessage, SceneMessage, StatusMessage,
                 StateMessage, StartedMessage, FinishedMessage, DroppedMessage, ObjectsMessage,
                 KitMessage, TickMessage, NotedMessage>;

}  // namespace percussionist::osc
