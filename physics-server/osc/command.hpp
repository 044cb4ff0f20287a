// What the server can be told over OSC: plain values, checked where the packet came in.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

namespace percussionist::osc {

/// Where a packet came from or goes to: a numeric address or a name, and a UDP port.
struct Peer {
    std::string host;
    std::string port;
    bool operator==(const Peer&) const = default;
};

struct Play {};
struct Stop {};

// How it plays, with what, and where; hands: 0 left, 1 right, none: both.

/// A multiple of the score's own tempo, reached within some time [s].
struct Tempo {
    double factor = 1.0, seconds = 0.0;
};
/// The tempo sways by a share within each so many seconds of the score.
struct Rubato {
    double depth = 0.0, period = 4.0;
};
struct SetGrip {
    bool french = false;
};
/// A gesture's name, or "score".
struct SetNuance {
    std::string name;
    std::optional<int> hand;
};
/// Of raised sticks, a factor.
struct SetHeight {
    double factor = 1.0;
};
/// Where on the head, a share of its radius.
struct SetPlace {
    double share = 0.75;
    std::optional<int> hand;
};
struct SetLeading {
    int hand = 1;
};
/// Of the head above the floor [m].
struct SetHeadHeight {
    double height = 0.92;
};
struct SetMembrane {
    double radius = 0.33, tension = 3500.0, density = 0.262;  ///< [m], [N/m], [kg/m^2]
};
struct SetMallet {
    double mass = 0.045, stiffness = 1e8;  ///< [kg], [N/m^a]
};
struct SetTracking {
    bool tips = true;
};
struct SetInverse {
    std::string name;
};
struct SetLaw {
    bool paper = false;
};
/// Of every joint [Hz]; 1: critical damping.
struct SetGain {
    double frequency = 20.0, damping = 1.0;
};

struct LoadScore {
    std::string path;
};
/// What a subscriber wants: sound hears contacts, clock and status; pose sees the body move.
enum class Feed { sound = 1, pose = 2, all = 3 };
struct Subscribe {
    Peer peer;  ///< no host: the asker's
    Feed feed = Feed::sound;
};
struct Unsubscribe {
    Peer peer;  ///< no host: the asker's
};
struct Ping {};
struct Describe {};

/// A route as its line of text (osc/route.hpp).
struct AddRoute {
    std::string line;
};
struct ChangeRoute {
    int number = 0;
    std::string line;
};
struct RemoveRoute {
    int number = 0;
};
struct ListRoutes {};
struct SaveRoutes {
    std::string file;
};
/// Records what is played to FILE; an empty one: no longer.
struct Record {
    std::string file;
};

// At a whole kit.

/// A song that plays elsewhere is at a place; when, in the server's time, if it says so [s].
struct SongPosition {
    double position = 0.0;
    std::optional<double> heard_at;
};
/// It stands, where it is or at a place [s].
struct SongPause {
    std::optional<double> position;
};
/// When a live note sounds.
enum class NoteSound { now, contact, none };
struct Note {
    int key = 38;
    double velocity = 0.5;  ///< 0..1
    NoteSound sound = NoteSound::now;
};
/// A limb's pose for an event is held, to be looked at; no limb: the drummer plays on.
struct ShowPose {
    std::string limb, event;
    bool up = false;
};
/// A joint of the pose that is shown: Euler angles z y x [rad].
struct TurnJoint {
    std::string joint;
    std::array<double, 3> angles{};
};
/// How a joint goes between key frames: words and numbers as in a kit file.
struct SetScript {
    std::string line;
};
struct SaveKit {
    std::string file;
};

using Command =
    std::variant<Play, Stop, Tempo, Rubato, SetGrip, SetNuance, SetHeight, SetPlace, SetLeading,
                 SetHeadHeight, SetMembrane, SetMallet, SetTracking, SetInverse, SetLaw, SetGain,
                 SongPosition, SongPause, Note, ShowPose, TurnJoint, SetScript, SaveKit, LoadScore,
                 Subscribe, Unsubscribe, Ping, Describe, AddRoute, ChangeRoute, RemoveRoute,
                 ListRoutes, SaveRoutes, Record>;

/// Whether only a drummer at a whole kit can do it.
inline bool needs_kit(const Command& command) {
    return std::visit(
        [](const auto& c) {
            using Wish = std::decay_t<decltype(c)>;
            return std::is_same_v<Wish, SongPosition> || std::is_same_v<Wish, SongPause> ||
                   std::is_same_v<Wish, Note> || std::is_same_v<Wish, ShowPose> ||
                   std::is_same_v<Wish, TurnJoint> || std::is_same_v<Wish, SetScript> ||
                   std::is_same_v<Wish, SaveKit>;
        },
        command);
}

}  // namespace percussionist::osc
