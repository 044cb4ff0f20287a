// What the server can be told over OSC: plain values, checked where the packet came in.
#pragma once

#include <string>
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
/// A multiple of the score's own tempo.
struct Tempo {
    double factor = 1.0;
};
struct LoadScore {
    std::string path;
    Peer asker;
};
/// What a subscriber wants: sound hears contacts, clock and status; pose sees the body move.
enum class Feed { sound = 1, pose = 2, all = 3 };
struct Subscribe {
    Peer peer, asker;
    Feed feed = Feed::sound;
};
struct Unsubscribe {
    Peer peer;
};
struct Ping {
    Peer asker;
};
struct Describe {
    Peer asker;
};

/// A route as its line of text (osc/route.hpp).
struct AddRoute {
    std::string line;
    Peer asker;
};
struct ChangeRoute {
    int number = 0;
    std::string line;
    Peer asker;
};
struct RemoveRoute {
    int number = 0;
    Peer asker;
};
struct ListRoutes {
    Peer asker;
};
struct SaveRoutes {
    std::string file;
    Peer asker;
};
/// Records what is played to FILE; an empty one: no longer.
struct Record {
    std::string file;
    Peer asker;
};

using Command = std::variant<Play, Stop, Tempo, LoadScore, Subscribe, Unsubscribe, Ping, Describe,
                             AddRoute, ChangeRoute, RemoveRoute, ListRoutes, SaveRoutes, Record>;

}  // namespace percussionist::osc
