// The server's end of the wire: a thread that hears commands, a thread that tells subscribers.
//
// The simulating thread calls tell() and take_commands(); neither waits for a socket (a call of
// send costs tens of microseconds) nor for a name to be looked up. Losing packets loses no stroke:
// every contact is sent again a few times within the lookahead, and the last few ride along with
// each.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "osc/outgoing.hpp"
#include "osc/udp_socket.hpp"
#include "osc/wire.hpp"

namespace percussionist::osc {

struct EndpointOptions {
    std::string listen = "127.0.0.1";  ///< address to bind to
    int port = 7770;
    double lookahead = 0.030;  ///< [s]
};

class Endpoint {
  public:
    /// Both threads start here. `wall` reads the server's steady wall clock [s]; called from the
    /// sending thread. Throws std::runtime_error if the port cannot be had.
    Endpoint(const EndpointOptions& options, std::function<double()> wall);
    ~Endpoint();

    [[nodiscard]] int port() const { return socket_.port(); }
    [[nodiscard]] int subscribers() const;

    /// Hands a message to the sending thread. Any thread; may take memory, waits for no I/O.
    void tell(Outgoing message);
    /// A question's answer, to the asker alone.
    void answer(const Peer& asker, const std::string& address, std::vector<std::string> texts);
    /// What has been asked for since the last call, in order. Simulating thread.
    std::vector<Command> take_commands();

  private:
    struct Subscriber {
        Peer peer;
        sockaddr_in address;
        Feed feed;
    };
    struct Repeat {
        double wall;
        Packet packet;
    };
    void hear();
    void handle(const Command& command);
    void subscribe(const Subscribe& wish);
    void remove(const Peer& peer);
    void describe(const Peer& asker);
    void refuse(const Refusal& refusal, const Peer& sender);
    void send_loop();
    void send_contact(const ContactMessage& contact);
    void send_due(double now);
    void send(const Outgoing& message);
    void broadcast(const Packet& packet, Feed feed);

    EndpointOptions options_;
    std::function<double()> wall_;
    UdpSocket socket_;

    mutable std::mutex mutex_;  ///< guards all below but what the sending thread alone uses
    std::condition_variable wake_;
    std::vector<Subscriber> subscribers_;
    std::vector<Command> commands_;
    std::deque<Outgoing> outgoing_;
    bool stopping_ = false;

    std::deque<ContactMessage> recent_;  ///< sending thread: newest first
    std::deque<Repeat> repeats_;         ///< sending thread
    double next_clock_ = 0.0;            ///< sending thread

    std::thread hearing_, sending_;
};

}  // namespace percussionist::osc
