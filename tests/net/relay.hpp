// A network worse than loopback: takes UDP packets and passes them on late, some twice, some never,
// out of order as their delays will have it. What becomes of the n-th packet depends on the seed
// alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "io/udp_socket.hpp"

namespace percussionist::test {

struct RelaySettings {
    double delay = 0.0;   ///< of every packet [s]
    double jitter = 0.0;  ///< at most that much more, evenly spread [s]
    double loss = 0.0;    ///< of packets, 0 to 1
    double doubled = 0.0;
    std::uint64_t seed = 1;
};

class Relay {
  public:
    /// Listens on this machine alone, or by `address` ("0.0.0.0": by all of its networks).
    Relay(int port, const io::Endpoint& to, const RelaySettings& settings,
          const std::string& address = "127.0.0.1");
    ~Relay();
    Relay(const Relay&) = delete;
    Relay& operator=(const Relay&) = delete;

    int port() const { return socket_.port(); }
    /// The cable is out (nothing passes), or in again.
    void cut(bool out) { cut_ = out; }

  private:
    void run();

    io::UdpSocket socket_;
    io::Endpoint to_;
    RelaySettings settings_;
    std::atomic<bool> ending_{false}, cut_{false};
    std::thread thread_;
};

}  // namespace percussionist::test
