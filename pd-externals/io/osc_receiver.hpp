// A thread that listens to a UDP port and hands over what is due when (see OscInbox), and that
// sends to one server.
//
// Deliveries come and go by two lock-free queues: next() takes one, give_back() returns it, so that
// its memory is freed where it was taken. All public functions are for one thread, which they never
// keep waiting: no lock, no name to be looked up. (Creation and destruction start and end the
// thread.)
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "io/host_lookup.hpp"
#include "io/osc_inbox.hpp"
#include "io/server_search.hpp"
#include "io/spsc_ring.hpp"
#include "io/udp_socket.hpp"

namespace percussionist::io {

class OscReceiver {
  public:
    static constexpr std::size_t kMostWaiting = 16384;  ///< deliveries

    struct Status : OscInbox::Status {
        double dropped = 0;  ///< packets or deliveries for which there was no room
    };

    /// How a server is found by its name.
    struct Naming {
        HostLookup::Ask ask = HostLookup::ask_system;
        double again = 3.0;  ///< after there was no such host [s]
    };

    /// As UdpSocket; throws as that does.
    OscReceiver(const std::string& address, int port) : OscReceiver(address, port, Naming{}) {}
    OscReceiver(const std::string& address, int port, Naming naming);
    ~OscReceiver();
    OscReceiver(const OscReceiver&) = delete;
    OscReceiver& operator=(const OscReceiver&) = delete;

    int port() const { return socket_.port(); }

    /// Null if there is none.
    std::unique_ptr<Delivery> next() noexcept;
    void give_back(std::unique_ptr<Delivery> delivery) noexcept;

    /// A few milliseconds old at most; its offset is that of the wall clocks [s].
    Status status() const noexcept;

    /// Where to send to. While there is no such host it is looked up again and again; what was sent
    /// to it meanwhile is dropped.
    void set_server(const std::string& host, int port);
    void send(Bytes packet);
    /// Now and every second, until told otherwise by another, or by an empty one.
    void send_often(Bytes packet);
    /// This is sent last of all; then the receiver has to be destroyed.
    void end_with(Bytes packet) noexcept { last_ = std::move(packet); }
    /// Looks for servers on this machine's networks for 3 s: each comes as a delivery.
    void find();

  private:
    struct Command {
        enum class Kind { kServer, kSend, kOften, kFind } kind = Kind::kSend;
        std::string host;
        int port = 0;
        Bytes packet;
    };
    static constexpr std::size_t kNumbers = sizeof(Status) / sizeof(double);

    void run();
    void wait() const;
    void obey_commands();
    void obey(Command& command);
    void head_for(const std::string& host, std::uint16_t port);
    bool knows_server(double now);
    void send_what_waits(double now);
    void search(double now);
    void hand_over(std::unique_ptr<Delivery> delivery);
    void complain(const std::string& text);
    void publish_status();
    void command(Command command);
    void wake() const noexcept;

    UdpSocket socket_;
    OscInbox inbox_;
    int waker_;
    std::atomic<bool> ending_{false};
    Bytes last_;  // the thread's once ending_
    std::array<std::atomic<double>, kNumbers> status_{};
    SpscRing<std::unique_ptr<Delivery>> deliveries_{kMostWaiting};
    SpscRing<std::unique_ptr<Delivery>> returned_{4 * kMostWaiting};
    SpscRing<Command> commands_{256};

    // The thread's own.
    double refused_ = 0;
    Naming naming_;
    std::optional<HostLookup> lookup_;
    double look_up_at_ = 0.0;
    std::optional<ServerSearch> search_;
    Endpoint server_;
    std::string server_name_;
    std::deque<Bytes> to_send_;
    Bytes often_;
    double sent_often_ = 0.0;
    int last_wrong_ = 0;    // errno of the last packet sent
    bool unknown_ = false;  // there is no such host, as was said

    std::thread thread_;
};

}  // namespace percussionist::io
