#include "io/udp_socket.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "io/monotonic.hpp"

namespace percussionist::io {

namespace {

constexpr std::size_t kBatch = 32;
constexpr std::size_t kLongest = 65536;
constexpr int kKernelBuffer = 8 << 20;  // bytes: a burst of thousands of packets
constexpr double kOldestStamp = 10.0;   // [s]

sockaddr_in socket_address(const Endpoint& endpoint) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(endpoint.address);
    address.sin_port = htons(endpoint.port);
    return address;
}

template <class Option>
bool set(int handle, int name, Option value) {
    return setsockopt(handle, SOL_SOCKET, name, &value, sizeof value) == 0;
}

/// What the kernel tells beside a packet.
template <class Value>
bool told(const msghdr& header, int type, Value& value) {
    auto* const all = const_cast<msghdr*>(&header);
    for (cmsghdr* c = CMSG_FIRSTHDR(all); c; c = CMSG_NXTHDR(all, c)) {
        if (c->cmsg_level == SOL_SOCKET && c->cmsg_type == type) {
            std::memcpy(&value, CMSG_DATA(c), sizeof value);
            return true;
        }
    }
    return false;
}

}  // namespace

/// Room for packets that are read with one system call.
struct UdpSocket::Batch {
    struct Control {
        alignas(cmsghdr) std::array<char, 256> bytes;
    };
    std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(kBatch * kLongest);
    std::array<sockaddr_in, kBatch> from{};
    std::array<iovec, kBatch> parts{};
    std::array<Control, kBatch> control{};
    std::array<mmsghdr, kBatch> headers{};

    void prepare() {
        for (std::size_t i = 0; i < kBatch; ++i) {
            parts[i] = {bytes.data() + i * kLongest, kLongest};
            msghdr& header = headers[i].msg_hdr;
            header.msg_name = &from[i];
            header.msg_namelen = sizeof from[i];
            header.msg_iov = &parts[i];
            header.msg_iovlen = 1;
            header.msg_control = control[i].bytes.data();
            header.msg_controllen = control[i].bytes.size();
        }
    }
};

bool read_address(const std::string& text, std::uint32_t& address) {
    in_addr parsed{};
    if (inet_pton(AF_INET, text == "localhost" ? "127.0.0.1" : text.c_str(), &parsed) != 1) {
        return false;
    }
    address = ntohl(parsed.s_addr);
    return true;
}

UdpSocket::UdpSocket(const std::string& address, int port) : batch_(std::make_unique<Batch>()) {
    Endpoint own{0, static_cast<std::uint16_t>(port)};
    if (!read_address(address, own.address)) {
        throw std::runtime_error("address " + address + ": expected four numbers, as 0.0.0.0");
    }
    handle_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_in bound = socket_address(own);
    socklen_t size = sizeof bound;
    if (handle_ < 0 || bind(handle_, reinterpret_cast<sockaddr*>(&bound), size) != 0 ||
        getsockname(handle_, reinterpret_cast<sockaddr*>(&bound), &size) != 0) {
        const int reason = errno;
        if (handle_ >= 0) {
            close(handle_);
        }
        const std::string where = port == 0 ? address : address + " port " + std::to_string(port);
        throw std::runtime_error("cannot listen on " + where + ": " + std::strerror(reason));
    }
    port_ = ntohs(bound.sin_port);
    // More than the machine allows everybody needs a privilege.
    if (!set(handle_, SO_RCVBUFFORCE, kKernelBuffer)) {
        set(handle_, SO_RCVBUF, kKernelBuffer);
    }
    set(handle_, SO_TIMESTAMPNS, 1);
    set(handle_, SO_RXQ_OVFL, 1);
}

UdpSocket::~UdpSocket() {
    close(handle_);
}

bool UdpSocket::receive(const Take& take) {
    batch_->prepare();
    const int count = recvmmsg(handle_, batch_->headers.data(), kBatch, MSG_DONTWAIT, nullptr);
    if (count <= 0) {
        return false;
    }
    const double now = monotonic_seconds();
    const double monotonic_less_real = now - read_clock(CLOCK_REALTIME);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const msghdr& header = batch_->headers[i].msg_hdr;
        const double arrival = stamp(&header, monotonic_less_real, now);
        take({batch_->bytes.data() + i * kLongest, batch_->headers[i].msg_len},
             {ntohl(batch_->from[i].sin_addr.s_addr), ntohs(batch_->from[i].sin_port)}, arrival);
    }
    return static_cast<std::size_t>(count) == kBatch;
}

/// The kernel stamps by the clock that may be set; if it just was, now is the better guess.
double UdpSocket::stamp(const void* header, double monotonic_less_real, double now) {
    const auto& all = *static_cast<const msghdr*>(header);
    told(all, SO_RXQ_OVFL, dropped_);
    timespec arrived{};
    if (!told(all, SCM_TIMESTAMPNS, arrived)) {
        return now;
    }
    const double arrival = seconds(arrived) + monotonic_less_real;
    return arrival > now || arrival < now - kOldestStamp ? now : arrival;
}

bool UdpSocket::send(const Endpoint& to, std::span<const std::uint8_t> bytes) const {
    const sockaddr_in address = socket_address(to);
    return sendto(handle_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                  reinterpret_cast<const sockaddr*>(&address), sizeof address) >= 0;
}

}  // namespace percussionist::io
