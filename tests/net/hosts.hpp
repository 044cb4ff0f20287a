// Three hosts on one machine, as network namespaces: one of the server, one of Pd, and this process
// between them, with a network to each. No packet gets from one to the other but by a relay here.
//
//     server 10.77.1.2 --- 10.77.1.1 here 10.77.2.1 --- 10.77.2.2 Pd
//
// Needs the right to make namespaces: as root, or where the kernel gives it to users.
#pragma once

#include <sys/types.h>

#include <array>
#include <string>

namespace percussionist::test {

class Hosts {
  public:
    /// Only while there is one thread: all of the process moves. Throws std::runtime_error where
    /// the kernel forbids it.
    Hosts();
    ~Hosts();
    Hosts(const Hosts&) = delete;
    Hosts& operator=(const Hosts&) = delete;

    std::string server_network() const { return network(holders_[0]); }
    std::string pd_network() const { return network(holders_[1]); }

    /// Another address of this process on the network of the server: 10.77.1.LAST.
    static void readdress(int last);

  private:
    static std::string network(pid_t holder);

    std::array<pid_t, 2> holders_{};
};

}  // namespace percussionist::test
