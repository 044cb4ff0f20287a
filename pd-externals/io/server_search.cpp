#include "io/server_search.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace percussionist::io {

namespace {

constexpr const char* kService = "_percussionist._udp.local";
constexpr Endpoint kEverybody{0xE00000FB, 5353};      // 224.0.0.251
constexpr std::array<double, 3> kAsk{0.0, 0.3, 1.2};  // [s]
constexpr double kLongest = 3.0;                      // [s]

/// The addresses of this machine, one of each network that hears multicast.
std::vector<in_addr> networks() {
    std::vector<in_addr> all;
    ifaddrs* list = nullptr;
    if (getifaddrs(&list) != 0) {
        return all;
    }
    for (const ifaddrs* one = list; one; one = one->ifa_next) {
        if (one->ifa_addr && one->ifa_addr->sa_family == AF_INET && (one->ifa_flags & IFF_UP) &&
            (one->ifa_flags & IFF_MULTICAST)) {
            all.push_back(reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr);
        }
    }
    freeifaddrs(list);
    return all;
}

std::unique_ptr<UdpSocket> open_on(in_addr network) {
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &network, text.data(), text.size());
    auto socket = std::make_unique<UdpSocket>(text.data(), 0);
    setsockopt(socket->handle(), IPPROTO_IP, IP_MULTICAST_IF, &network, sizeof network);
    return socket;
}

}  // namespace

ServerSearch::ServerSearch(double now) : began_(now), answers_(kService) {
    for (const in_addr network : networks()) {
        try {
            sockets_.push_back(open_on(network));
        } catch (const std::runtime_error&) {
            // This network has just gone.
        }
    }
}

bool ServerSearch::over(double now) const {
    return now - began_ > kLongest;
}

std::vector<FoundServer> ServerSearch::step(double now) {
    for (; asked_ < kAsk.size() && now - began_ >= kAsk[asked_]; ++asked_) {
        for (const auto& socket : sockets_) {
            socket->send(kEverybody, dns_sd_question(kService));
        }
    }
    for (const auto& socket : sockets_) {
        const auto take = [this](auto bytes, const Endpoint& from, double /*arrival*/) {
            if (from.port == kEverybody.port) {
                answers_.take(bytes);
            }
        };
        while (socket->receive(take)) {
        }
    }
    std::vector<FoundServer> fresh;
    for (const FoundServer& server : answers_.found()) {
        if (std::find(told_.begin(), told_.end(), server) == told_.end()) {
            told_.push_back(server);
            fresh.push_back(server);
        }
    }
    return fresh;
}

}  // namespace percussionist::io
