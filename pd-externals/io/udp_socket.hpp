// A UDP port (IPv4) that is listened to, with the times at which packets reached the machine.
//
// The kernel stamps each packet; so it does not matter when the thread gets to read it. Nothing
// here waits: wait for handle() to be readable. One thread at a time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "io/osc_inbox.hpp"

namespace percussionist::io {

class UdpSocket {
  public:
    /// `address` in numbers, 0.0.0.0 for all of the machine's; port 0 for any free one. Throws
    /// std::runtime_error: "cannot listen on 0.0.0.0 port 7771: Address already in use".
    UdpSocket(const std::string& address, int port);
    ~UdpSocket();
    UdpSocket(const UdpSocket&) = delete;
    UdpSocket& operator=(const UdpSocket&) = delete;

    int handle() const { return handle_; }
    int port() const { return port_; }

    using Take =
        std::function<void(std::span<const std::uint8_t>, const Endpoint&, double arrival)>;
    /// Hands over what waits, a few packets at most; false once there is nothing more.
    bool receive(const Take& take);
    /// Packets the kernel had no room for.
    unsigned dropped() const { return dropped_; }

    /// False if it could not be sent: errno tells.
    bool send(const Endpoint& to, std::span<const std::uint8_t> bytes) const;

  private:
    struct Batch;
    double stamp(const void* header, double monotonic_less_real, double now);

    int handle_ = -1;
    int port_ = 0;
    unsigned dropped_ = 0;
    std::unique_ptr<Batch> batch_;
};

/// "127.0.0.1", or localhost; false for anything that would have to be looked up.
bool read_address(const std::string& text, std::uint32_t& address);

}  // namespace percussionist::io
