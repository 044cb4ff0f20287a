// A UDP socket that both listens and sends, so that subscribers know the server by one address.
//
// Throws std::runtime_error with one clear line. send() and receive() may be called from different
// threads at once.
#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "osc/command.hpp"

namespace percussionist::osc {

class UdpSocket {
  public:
    /// Binds to `host` (a numeric address or a name; "0.0.0.0" for all) and `port` (0: any free).
    UdpSocket(const std::string& host, int port);
    ~UdpSocket();
    UdpSocket(const UdpSocket&) = delete;
    UdpSocket& operator=(const UdpSocket&) = delete;

    [[nodiscard]] int port() const;

    struct Received {
        std::size_t size;
        sockaddr_in from;
    };
    /// Waits up to `timeout_ms` for a packet.
    std::optional<Received> receive(std::span<char> buffer, int timeout_ms);
    /// False if the system refused it (nothing listens there, no route).
    bool send(std::span<const char> bytes, const sockaddr_in& to);

    /// A peer to whom something was sent and whose machine has answered that nobody listens there;
    /// nothing if there is none (any more).
    std::optional<sockaddr_in> unreachable();

    /// Looks a host up; throws if there is none. May take seconds for a name.
    static sockaddr_in resolve(const std::string& host, const std::string& port);
    static Peer peer(const sockaddr_in& address);
    /// An address written in numbers, or localhost; nothing for a name that has to be looked up.
    static std::optional<in_addr_t> numeric(const std::string& host);
    /// `port` in figures.
    static sockaddr_in address(in_addr_t host, const std::string& port);

  private:
    int fd_ = -1;
};

}  // namespace percussionist::osc
