#include "io/host_lookup.hpp"

#include <netdb.h>
#include <netinet/in.h>

#include <thread>

#include "io/udp_socket.hpp"

namespace percussionist::io {

std::uint32_t HostLookup::ask_system(const std::string& host) {
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) {
        return 0;
    }
    const auto address = ntohl(reinterpret_cast<sockaddr_in*>(found->ai_addr)->sin_addr.s_addr);
    freeaddrinfo(found);
    return address;
}

HostLookup::HostLookup(const std::string& host, const Ask& ask) {
    if (read_address(host, answer_->address)) {
        answer_->done = true;
        return;
    }
    // It may outlive this object, but not what it writes to.
    std::thread([host, ask, answer = answer_] {
        answer->address = ask(host);
        answer->done.store(true, std::memory_order_release);
    }).detach();
}

}  // namespace percussionist::io
