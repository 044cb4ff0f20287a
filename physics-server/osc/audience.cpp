#include "osc/audience.hpp"

#include <algorithm>
#include <stdexcept>

#include "osc/udp_socket.hpp"

namespace percussionist::osc {

bool same(const sockaddr_in& a, const sockaddr_in& b) {
    return a.sin_addr.s_addr == b.sin_addr.s_addr && a.sin_port == b.sin_port;
}

void Audience::subscribe(const sockaddr_in& who, Feed feed, double now) {
    const std::lock_guard lock(mutex_);
    for (Subscriber& s : subscribers_) {
        if (!same(s.address, who)) continue;
        s.feed = feed;
        s.heard = now;
        s.renews = true;
        return;
    }
    if (subscribers_.size() >= kMostSubscribers) {
        throw std::runtime_error("no more than 32 subscribers");
    }
    subscribers_.push_back({who, feed, now, false});
}

int Audience::subscribers() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(subscribers_.size());
}

std::size_t Audience::listeners(Feed feed, Addresses& to) const {
    const std::lock_guard lock(mutex_);
    std::size_t count = 0;
    for (const Subscriber& s : subscribers_) {
        const int wanted = static_cast<int>(s.feed) & static_cast<int>(feed);
        if (wanted != 0) to[count++] = s.address;
    }
    return count;
}

bool Audience::drop(const sockaddr_in& who) {
    const std::lock_guard lock(mutex_);
    return std::erase_if(subscribers_, [&](const Subscriber& s) { return same(s.address, who); }) >
           0;
}

std::vector<Peer> Audience::drop_silent(double now) {
    const std::lock_guard lock(mutex_);
    std::vector<Peer> dropped;
    std::erase_if(subscribers_, [&](const Subscriber& s) {
        const bool silent = s.renews && now - s.heard > kLease;
        if (silent) dropped.push_back(UdpSocket::peer(s.address));
        return silent;
    });
    return dropped;
}

int Audience::add_route(const Route& route, const sockaddr_in& to) {
    const std::lock_guard lock(mutex_);
    if (routes_.size() >= kMostRoutes) throw std::runtime_error("no more than 128 routes");
    int number = 1;
    while (numbered(number)) ++number;
    routes_.push_back({number, route, to});
    return number;
}

bool Audience::numbered(int number) const {
    return std::any_of(routes_.begin(), routes_.end(),
                       [number](const NumberedRoute& r) { return r.number == number; });
}

bool Audience::change_route(int number, const Route& route, const sockaddr_in& to) {
    const std::lock_guard lock(mutex_);
    for (NumberedRoute& r : routes_) {
        if (r.number != number) continue;
        r.route = route;
        r.to = to;
        return true;
    }
    return false;
}

bool Audience::remove_route(int number) {
    const std::lock_guard lock(mutex_);
    return std::erase_if(routes_, [number](const NumberedRoute& r) { return r.number == number; }) >
           0;
}

std::vector<std::pair<int, std::string>> Audience::routes() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::pair<int, std::string>> all;
    for (const NumberedRoute& r : routes_) all.emplace_back(r.number, to_string(r.route));
    return all;
}

bool Audience::wanted(EventKind kind) const {
    const std::lock_guard lock(mutex_);
    return std::any_of(routes_.begin(), routes_.end(),
                       [kind](const NumberedRoute& r) { return r.route.event == kind; });
}

void Audience::route(const Event& event,
                     const std::function<void(const Route&, const sockaddr_in&)>& send) const {
    std::vector<NumberedRoute> going;
    {
        const std::lock_guard lock(mutex_);
        std::copy_if(routes_.begin(), routes_.end(), std::back_inserter(going),
                     [&event](const NumberedRoute& r) { return matches(r.route, event); });
    }
    for (const NumberedRoute& r : going) send(r.route, r.to);
}

}  // namespace percussionist::osc
