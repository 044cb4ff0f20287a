#include "osc/udp_socket.hpp"

#include <arpa/inet.h>
#include <linux/errqueue.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace percussionist::osc {

namespace {

/// Of what the kernel reports about a packet that was sent.
int reason(msghdr& message) {
    for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
        if (c->cmsg_level != IPPROTO_IP || c->cmsg_type != IP_RECVERR) continue;
        sock_extended_err error{};
        std::memcpy(&error, CMSG_DATA(c), sizeof error);
        return static_cast<int>(error.ee_errno);
    }
    return 0;
}

}  // namespace

sockaddr_in UdpSocket::resolve(const std::string& host, const std::string& port) {
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    const int error = getaddrinfo(host.c_str(), port.c_str(), &hints, &found);
    if (error != 0 || found == nullptr) {
        throw std::runtime_error("no host '" + host + "' (" + gai_strerror(error) + ")");
    }
    sockaddr_in address{};
    std::memcpy(&address, found->ai_addr, sizeof address);
    freeaddrinfo(found);
    return address;
}

Peer UdpSocket::peer(const sockaddr_in& address) {
    char text[INET_ADDRSTRLEN] = "";
    inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
    return {text, std::to_string(ntohs(address.sin_port))};
}

std::optional<in_addr_t> UdpSocket::numeric(const std::string& host) {
    in_addr address{};
    const char* text = host == "localhost" ? "127.0.0.1" : host.c_str();
    if (inet_pton(AF_INET, text, &address) != 1) return std::nullopt;
    return address.s_addr;
}

sockaddr_in UdpSocket::address(in_addr_t host, const std::string& port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = host;
    address.sin_port = htons(static_cast<std::uint16_t>(std::strtoul(port.c_str(), nullptr, 10)));
    return address;
}

UdpSocket::UdpSocket(const std::string& host, int port) {
    const sockaddr_in address = resolve(host, std::to_string(port));
    fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (fd_ < 0) throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
    if (bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        const int error = errno;
        close(fd_);
        throw std::runtime_error("cannot listen on " + host + " port " + std::to_string(port) +
                                 ": " + std::strerror(error));
    }
    const int on = 1;
    setsockopt(fd_, IPPROTO_IP, IP_RECVERR, &on, sizeof on);
}

std::optional<sockaddr_in> UdpSocket::unreachable() {
    sockaddr_in peer{};
    char payload[1];
    char control[512];
    iovec piece{payload, sizeof payload};
    msghdr message{};
    message.msg_name = &peer;
    message.msg_namelen = sizeof peer;
    message.msg_iov = &piece;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    // A cable that is out is another thing: who was told before is told again when it is in.
    while (recvmsg(fd_, &message, MSG_ERRQUEUE | MSG_DONTWAIT) >= 0) {
        if (reason(message) == ECONNREFUSED) return peer;
        message.msg_controllen = sizeof control;
    }
    return std::nullopt;
}

UdpSocket::~UdpSocket() {
    close(fd_);
}

int UdpSocket::port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

std::optional<UdpSocket::Received> UdpSocket::receive(std::span<char> buffer, int timeout_ms) {
    pollfd waiting{fd_, POLLIN, 0};
    if (poll(&waiting, 1, timeout_ms) <= 0) return std::nullopt;
    Received received{};
    socklen_t size = sizeof received.from;
    const ssize_t got = recvfrom(fd_, buffer.data(), buffer.size(), MSG_DONTWAIT,
                                 reinterpret_cast<sockaddr*>(&received.from), &size);
    // Woken by the echo of a send that nobody listened to, which a send may have taken since:
    // nothing has come.
    if (got < 0) return std::nullopt;
    received.size = static_cast<std::size_t>(got);
    return received;
}

bool UdpSocket::send(std::span<const char> bytes, const sockaddr_in& to) {
    // What one peer's machine has answered before is reported by the next call, whoever that is to.
    constexpr int kTries = 4;
    for (int i = 0; i < kTries; ++i) {
        if (sendto(fd_, bytes.data(), bytes.size(), MSG_DONTWAIT,
                   reinterpret_cast<const sockaddr*>(&to), sizeof to) >= 0) {
            return true;
        }
        if (errno != ECONNREFUSED && errno != EHOSTUNREACH) return false;
    }
    return false;
}

}  // namespace percussionist::osc
