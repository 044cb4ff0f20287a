// [osc-receive PORT]: OSC over UDP, each message at the very time its time tag names; see
// docs/osc-protocol.md, io/osc_receiver.hpp and io/playout.hpp.
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/monotonic.hpp"
#include "io/osc_receiver.hpp"
#include "io/playout.hpp"
#include "io/udp_socket.hpp"
#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;
namespace io = percussionist::io;

class OscReceive : public Object {
  public:
    OscReceive(Box& box, const Arguments& creation)
        : Object(box),
          tick_clock_(*this, [this] { tick(); }),
          play_clock_(*this, [this] { play(); }),
          status_clock_(*this, [this] { tell_each_second(); }),
          port_(creation.integer(0)) {
        try {
            open(address_, port_);
        } catch (const std::exception& e) {
            error(e.what());  // until it is told of a port that it can have
        }
        tick_clock_.delay(0.0);
        status_clock_.delay(1.0);
    }
    ~OscReceive() override { close(); }

    void port(const Arguments& a) { open(address_, a.integer(0)); }
    void listen(const Arguments& a) { open(a.word(0), port_); }
    void latency(const Arguments& a) { playout_.set_latency(a.number(0)); }

    void subscribe(const Arguments& a) {
        if (a.word(0) != host_ || a.integer(1) != server_port_) {
            leave();
        }
        host_ = a.word(0);
        server_port_ = a.integer(1);
        subscribed_ = true;
        keep_subscribed();
    }
    void unsubscribe(const Arguments&) {
        leave();
        subscribed_ = false;
    }
    void feed(const Arguments& a) {
        const std::string feed = a.word(0);
        if (feed != "sound" && feed != "pose" && feed != "all") {
            throw std::invalid_argument("expected sound, pose or all, got " + feed);
        }
        feed_ = feed;
        keep_subscribed();
    }

    void send_out(const Arguments& a) {
        const std::string address = a.word(0);
        if (address.empty() || address.front() != '/') {
            throw std::invalid_argument("expected an address that begins with /, got " + address);
        }
        std::vector<io::OscValue> values;
        for (const Atom& atom : a.atoms().subspan(1)) {
            is_number(atom) ? values.emplace_back(std::get<double>(atom))
                            : values.emplace_back(std::get<const char*>(atom));
        }
        receiver().send(io::write_osc(address, values));
    }

    void find(const Arguments&) { receiver().find(); }

    void status(const Arguments&) {
        const auto s = receiver_ ? receiver_->status() : io::OscReceiver::Status{};
        const std::pair<const char*, double> lines[] = {
            {"port", receiver_ ? receiver_->port() : 0},
            {"received", s.received},
            {"lost", s.lost},
            {"late", static_cast<double>(playout_.late())},
            {"latest", playout_.latest()},
            {"repeated", s.repeated},
            {"malformed", s.malformed},
            {"dropped", s.dropped},
            {"senders", s.senders},
            {"lookahead", s.lookahead},
            {"offset", s.offset},
            {"rate", s.rate * 1e6},
            {"jitter", s.jitter},
        };
        for (const auto& [name, value] : lines) {
            const Atom atom = value;
            send(1, name, std::span(&atom, 1));
        }
    }

  private:
    /// Listens there instead. Where it cannot it throws, and listens where it did.
    void open(const std::string& address, int port) {
        if (receiver_ && receiver_->port() == port) {
            reopen(address);
        } else {
            auto other = std::make_unique<io::OscReceiver>(address, port);
            close();
            begin(std::move(other));
        }
        address_ = address;
        port_ = port;
    }

    /// By another address: two cannot have the same port.
    void reopen(const std::string& address) {
        if (address == address_) {
            return;
        }
        const int port = receiver_->port();
        const io::UdpSocket possible(address, 0);  // while the other still listens
        close();
        try {
            begin(std::make_unique<io::OscReceiver>(address, port));
        } catch (const std::exception&) {
            begin(std::make_unique<io::OscReceiver>(address_, port));
            throw;
        }
    }

    void begin(std::unique_ptr<io::OscReceiver> receiver) {
        receiver_ = std::move(receiver);
        receiver_->set_server(host_, server_port_);
        keep_subscribed();
    }

    void close() noexcept {
        if (receiver_ && subscribed_) {
            receiver_->end_with(subscription("/unsubscribe", false));
        }
        receiver_.reset();
    }

    io::OscReceiver& receiver() const {
        if (!receiver_) {
            throw std::runtime_error("it has no port: send it port N");
        }
        return *receiver_;
    }

    void keep_subscribed() {
        if (receiver_ && subscribed_) {
            receiver_->set_server(host_, server_port_);
            receiver_->send_often(subscription("/subscribe", true));
        }
    }
    void leave() {
        if (receiver_ && subscribed_) {
            receiver_->send_often({});
            receiver_->send(subscription("/unsubscribe", false));
        }
    }
    io::Bytes subscription(const char* address, bool with_feed) const {
        std::vector<io::OscValue> values{static_cast<double>(receiver_->port())};
        if (with_feed) {
            values.emplace_back(feed_);
        }
        return io::write_osc(address, values, true);
    }

    /// Once a tick: what has arrived, and what is due within the tick.
    void tick() {
        tick_end_ = now() + tick_length();
        tick_clock_.delay(tick_length());
        playout_.tick(now(), io::monotonic_seconds());
        while (receiver_ && !playout_.full()) {
            auto delivery = receiver_->next();
            if (!delivery) {
                break;
            }
            if (!delivery->complaint.empty()) {
                error(delivery->complaint);
            } else if (delivery->found) {
                tell(*delivery->found);
            } else {
                playout_.add(std::move(delivery));
                continue;
            }
            give_back(std::move(delivery));
        }
        play();
    }

    void play() {
        while (auto delivery = playout_.take(now())) {
            for (const auto& message : delivery->messages) {
                let_out(message);
            }
            give_back(std::move(delivery));
        }
        if (playout_.next() < tick_end_) {
            play_clock_.at(playout_.next());
        }
    }

    /// What was sent out may have closed the port.
    void give_back(std::unique_ptr<io::Delivery> delivery) {
        if (receiver_) {
            receiver_->give_back(std::move(delivery));
        }
    }

    void tell(const io::FoundServer& server) {
        const std::string where = to_string(io::Endpoint{server.address, server.port});
        const std::string host = where.substr(0, where.find(':'));
        const std::array<Atom, 3> atoms{host.c_str(), static_cast<double>(server.port),
                                        server.name.c_str()};
        send(1, "found", atoms);
    }

    void let_out(const io::OscMessage& message) {
        atoms_.clear();
        for (const auto& value : message.arguments) {
            const auto* const word = std::get_if<std::string>(&value);
            word ? atoms_.emplace_back(word->c_str())
                 : atoms_.emplace_back(std::get<double>(value));
        }
        send(0, message.address.c_str(), atoms_);
    }

    void tell_each_second() {
        status_clock_.delay(1.0);
        status({{}, 0});
    }

    Clock tick_clock_, play_clock_, status_clock_;
    std::string address_ = "0.0.0.0";
    int port_;
    std::string host_ = "127.0.0.1";
    int server_port_ = 7770;
    std::string feed_ = "sound";
    bool subscribed_ = false;
    io::Playout playout_{io::OscReceiver::kMostWaiting};
    std::unique_ptr<io::OscReceiver> receiver_;
    double tick_end_ = 0.0;
    std::vector<Atom> atoms_;
};

}  // namespace

PDX_SETUP(setup_osc0x2dreceive) {
    const auto port = number("port").from(0).to(65535);
    add_class(
        describe<OscReceive>("osc-receive", "OSC over UDP, each message at its exact time")
            .creation({port.by_default(7771)})
            .message("port", {port}, "listens there instead, 0: any free one", &OscReceive::port)
            .message("listen", {word("address")},
                     "by which of the machine's addresses it can be reached, 0.0.0.0: by all",
                     &OscReceive::listen)
            .message("latency", {number("latency", "s").from(0).to(10)},
                     "lets what has a time tag out that much later", &OscReceive::latency)
            .message("subscribe",
                     {word("host").by_default_word("127.0.0.1"),
                      number("port").from(1).to(65535).by_default(7770)},
                     "asks a server for its messages, again and again so that one started anew "
                     "hears it too",
                     &OscReceive::subscribe)
            .message("feed", {word("feed")}, "what to ask for: sound, pose or all",
                     &OscReceive::feed)
            .message("unsubscribe", {}, "asks for no more", &OscReceive::unsubscribe)
            .message("send", {word("address"), anything("arguments")},
                     "tells the server that subscribe names", &OscReceive::send_out)
            .message("find", {},
                     "looks for servers on this machine's networks for 3 s; each found: HOST PORT "
                     "NAME",
                     &OscReceive::find)
            .message("status", {}, "tells now how it goes", &OscReceive::status)
            .outlet("each message, its address as selector")
            .outlet("each second, a message each: port received lost late latest [s] repeated "
                    "malformed dropped senders lookahead [s] offset [s] rate [ppm] jitter [s]; "
                    "after find: "
                    "found HOST PORT NAME"));
}
