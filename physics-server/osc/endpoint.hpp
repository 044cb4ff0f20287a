// The server's end of the wire: a thread that hears commands, a thread that tells subscribers.
//
// The simulating thread calls tell() and take_commands(); neither waits for a socket (a call of
// send costs tens of microseconds) nor for a name to be looked up. Losing packets loses no stroke:
// every contact is sent again a few times within the lookahead, and the last few ride along with
// each.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "osc/answer_budget.hpp"
#include "osc/audience.hpp"
#include "osc/outgoing.hpp"
#include "osc/udp_socket.hpp"
#include "osc/wire.hpp"

namespace percussionist::osc {

struct EndpointOptions {
    std::string listen = "127.0.0.1";  ///< address to bind to
    int port = 7770;
    double lookahead = 0.030;  ///< [s]
    /// Hosts that may be sent to at another's wish; always allowed are this machine and who asks.
    std::vector<std::string> allow;
    std::vector<std::string> routes;  ///< from the start, as lines of text
    /// What the sending thread does first: asks for a priority, say.
    std::function<void()> before_sending = [] {};
};

/// A command, and the message that it was.
struct Heard {
    Command command;
    std::string address;
    std::vector<Argument> arguments;
    Peer sender;
    double wall = 0.0;            ///< when it was heard [s]
    std::optional<double> tag{};  ///< of its bundle, by the sender's wall clock [s]
};

class Endpoint {
  public:
    /// Both threads start here. `wall` reads the server's steady wall clock [s]; called from both
    /// and from answer(), at once: it has to be thread-safe. Throws std::runtime_error if the port
    /// cannot be had.
    Endpoint(const EndpointOptions& options, std::function<double()> wall);
    ~Endpoint();

    [[nodiscard]] int port() const { return socket_.port(); }
    [[nodiscard]] int subscribers() const { return audience_.subscribers(); }
    [[nodiscard]] std::vector<std::pair<int, std::string>> routes() const {
        return audience_.routes();
    }

    /// Hands a message to the sending thread. Any thread; may take memory, waits for no I/O. Where
    /// the network is too slow for what is told, poses are left out.
    void tell(Outgoing message);
    /// A question's answer, to the asker alone, unless it asks too often (AnswerBudget) or has no
    /// host (in a replay).
    void answer(const Peer& asker, const std::string& address, std::vector<std::string> texts);
    /// What has been asked for, in order, a few at a time: obeying takes time. Simulating thread.
    std::vector<Heard> take_commands();

  private:
    struct Repeat {
        double wall;
        Packet packet;
        Feed feed;
    };
    void hear();
    void hear(std::span<const char> packet, const sockaddr_in& from);
    bool handled(const Command& command, const Peer& asker);
    void handle(const Subscribe& wish, const Peer& asker);
    void handle(const Unsubscribe& wish, const Peer& asker);
    void handle(const AddRoute& wish, const Peer& asker);
    void handle(const ChangeRoute& wish, const Peer& asker);
    void handle(const RemoveRoute& wish, const Peer& asker);
    void handle(const ListRoutes&, const Peer& asker);
    void handle(const Ping&, const Peer& asker);
    void handle(const Describe&, const Peer& asker);
    [[nodiscard]] in_addr_t known_host(const std::string& host) const;
    [[nodiscard]] sockaddr_in allowed_target(const Peer& to, const Peer& asker) const;
    void drop_unreachable();
    void drop_silent();
    void refuse(const Refusal& refusal, const Peer& sender);
    void send_loop();
    void send_contact(const ContactMessage& contact);
    void send_repeatedly(const Packet& packet, Feed feed);
    void send_due(double now);
    void send(const Outgoing& message);
    void send_picture(const Outgoing& message);
    std::size_t send_routed(const Event& event);
    void broadcast(const Packet& packet, Feed feed);

    EndpointOptions options_;
    std::function<double()> wall_;
    UdpSocket socket_;
    std::vector<in_addr_t> allowed_;  ///< numeric, of options.allow, in its order
    Audience audience_;

    std::atomic<bool> stopping_{false};

    // A lock each, none held for longer than a queue is changed or a budget is looked at. A flood
    // keeps the hearing thread busy, and who holds a lock may lose the processor: take_commands()
    // waits for none; tell() may wait for the sending thread, answer() for the hearing one.
    std::mutex commands_mutex_;
    std::deque<Heard> commands_;
    std::mutex answers_mutex_;
    AnswerBudget answers_;
    std::mutex outgoing_mutex_;
    std::condition_variable wake_;
    std::deque<Outgoing> outgoing_;
    std::deque<Outgoing> pictures_;  ///< poses and scenes: sent when nothing else waits

    std::deque<ContactMessage> recent_;  ///< sending thread: newest first
    std::deque<Repeat> repeats_;         ///< sending thread
    double next_clock_ = 0.0;            ///< sending thread
    double next_check_ = 0.0;            ///< of silent subscribers; hearing thread

    std::thread hearing_, sending_;
};

}  // namespace percussionist::osc
