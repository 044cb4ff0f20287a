// DNS-based service discovery over multicast DNS: the question for a service, and what answers say.
//
// A question from any port but 5353 is answered to that port alone, with the records of host and
// port beside the names (RFC 6762, 6.7 and 6.3; RFC 6763, 12.1). Nothing here sends or waits; bytes
// of any kind do no harm, and what is kept of them is bounded. One thread at a time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/osc_packet.hpp"

namespace percussionist::io {

struct FoundServer {
    std::string name;  ///< as it calls itself: "percussionist on atlas"
    std::uint32_t address = 0;
    std::uint16_t port = 0;
    bool operator==(const FoundServer&) const = default;
};

/// The packet that asks for a service: "_percussionist._udp.local".
Bytes dns_sd_question(const std::string& service);

class DnsSdAnswers {
  public:
    explicit DnsSdAnswers(std::string service) : service_(std::move(service)) {}

    void take(std::span<const std::uint8_t> packet);
    /// Those of whom name, port and address are known, each once; no more than 64.
    std::vector<FoundServer> found() const;

  private:
    struct Place {
        std::string host;
        std::uint16_t port = 0;
    };
    std::string service_;
    std::map<std::string, Place> places_;             // of instances of the service
    std::map<std::string, std::uint32_t> addresses_;  // of hosts
};

}  // namespace percussionist::io
