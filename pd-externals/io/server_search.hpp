// Looks for servers on every network of this machine, for some seconds, by multicast DNS.
//
// Non-blocking: it has to be told again and again how late it is. One thread at a time.
#pragma once

#include <memory>
#include <vector>

#include "io/dns_sd.hpp"
#include "io/udp_socket.hpp"

namespace percussionist::io {

class ServerSearch {
  public:
    /// From now on. A machine without a network is searched in vain.
    explicit ServerSearch(double now);

    /// Asks, if it is time to, and reads what came; those found since the last time.
    std::vector<FoundServer> step(double now);
    bool over(double now) const;
    bool in_vain() const { return told_.empty(); }

  private:
    double began_;
    std::size_t asked_ = 0;
    DnsSdAnswers answers_;
    std::vector<std::unique_ptr<UdpSocket>> sockets_;  // one for each network
    std::vector<FoundServer> told_;
};

}  // namespace percussionist::io
