// Who is told what: subscribers, who hear the protocol, and routes, which send what they were asked
// to. Subscribers are watched: one whose port answers that nobody listens, or who used to renew and
// no longer does, is dropped.
//
// Any thread; nothing here waits for the network. Time is an argument [s].
#pragma once

#include <netinet/in.h>

#include <array>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "osc/command.hpp"
#include "osc/route.hpp"

namespace percussionist::osc {

class Audience {
  public:
    static constexpr std::size_t kMostSubscribers = 32;
    static constexpr std::size_t kMostRoutes = 128;
    /// Who has subscribed more than once is taken to renew, and dropped after this silence [s].
    static constexpr double kLease = 15.0;

    using Addresses = std::array<sockaddr_in, kMostSubscribers>;

    /// Subscribes, or renews. Throws std::runtime_error if there are too many.
    void subscribe(const sockaddr_in& who, Feed feed, double now);
    [[nodiscard]] int subscribers() const;
    /// Those who hear a feed; returns how many.
    std::size_t listeners(Feed feed, Addresses& to) const;

    /// Drops who wishes it or is known not to listen; true if there was one.
    bool drop(const sockaddr_in& who);
    /// Drops those whose lease has run out.
    std::vector<Peer> drop_silent(double now);

    /// Returns the route's number, the least from 1 on that is free. Throws std::runtime_error if
    /// there are too many.
    int add_route(const Route& route, const sockaddr_in& to);
    /// False if there is no such number.
    bool change_route(int number, const Route& route, const sockaddr_in& to);
    bool remove_route(int number);
    /// By number, as lines of text.
    [[nodiscard]] std::vector<std::pair<int, std::string>> routes() const;
    [[nodiscard]] bool wanted(EventKind kind) const;
    /// Calls `send` for each route that an event goes.
    void route(const Event& event,
               const std::function<void(const Route&, const sockaddr_in&)>& send) const;

  private:
    struct Subscriber {
        sockaddr_in address{};
        Feed feed = Feed::sound;
        double heard = 0.0;
        bool renews = false;
    };
    [[nodiscard]] bool numbered(int number) const;
    struct NumberedRoute {
        int number = 0;
        Route route;
        sockaddr_in to{};
    };
    mutable std::mutex mutex_;
    std::vector<Subscriber> subscribers_;
    std::vector<NumberedRoute> routes_;
};

bool same(const sockaddr_in& a, const sockaddr_in& b);

}  // namespace percussionist::osc
