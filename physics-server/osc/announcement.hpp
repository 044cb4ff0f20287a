// Tells the network that there is a server: as a service of DNS-SD, through the Avahi daemon, so
// that Pd and other programs find it without an address (`avahi-browse _percussionist._udp`).
//
// Where there is no Avahi, when the program was built or while it runs, nothing is told and nothing
// fails; a daemon that is started later is told then. A thread of its own.
#pragma once

#include <memory>

namespace percussionist::osc {

class Announcement {
  public:
    /// The server listens on this UDP port, on every network of the machine.
    explicit Announcement(int port);
    ~Announcement();
    Announcement(const Announcement&) = delete;
    Announcement& operator=(const Announcement&) = delete;

  private:
    class Avahi;
    std::unique_ptr<Avahi> avahi_;
};

}  // namespace percussionist::osc
