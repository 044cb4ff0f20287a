#include "osc/endpoint.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace percussionist::osc {

namespace {

/// How many events ride along: with them a packet still fits one Ethernet frame.
constexpr std::size_t kRideAlong = 7;
/// How often a contact is sent again, evenly over the lookahead that is left after it was known.
constexpr int kRepeats = 4;
constexpr double kRepeatShare = 1.0 / 8.0;
constexpr double kClockInterval = 0.01;
constexpr std::size_t kMostSubscribers = 32;
/// Commands not yet taken beyond this many are refused: memory is bounded.
constexpr std::size_t kMostCommands = 256;

}  // namespace

Endpoint::Endpoint(const EndpointOptions& options, std::function<double()> wall)
    : options_(options), wall_(std::move(wall)), socket_(options.listen, options.port) {
    hearing_ = std::thread([this] { hear(); });
    sending_ = std::thread([this] { send_loop(); });
}

Endpoint::~Endpoint() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    hearing_.join();
    sending_.join();
}

int Endpoint::subscribers() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(subscribers_.size());
}

void Endpoint::tell(Outgoing message) {
    {
        const std::lock_guard lock(mutex_);
        outgoing_.push_back(std::move(message));
    }
    wake_.notify_one();
}

std::vector<Command> Endpoint::take_commands() {
    const std::lock_guard lock(mutex_);
    return std::exchange(commands_, {});
}

void Endpoint::hear() {
    std::array<char, 65536> buffer;
    constexpr int kCheckStopping = 50;
    while (true) {
        const auto received = socket_.receive(buffer, kCheckStopping);
        {
            const std::lock_guard lock(mutex_);
            if (stopping_) return;
        }
        if (!received) continue;
        const Peer sender = UdpSocket::peer(received->from);
        const auto message = [&](const std::string& path, std::span<const Argument> arguments) {
            const auto said = understand(path, arguments, sender);
            if (const auto* refusal = std::get_if<Refusal>(&said)) {
                refuse(*refusal, sender);
            } else {
                handle(std::get<Command>(said));
            }
        };
        if (!decode({buffer.data(), received->size}, message)) {
            refuse({"packet", "expected an OSC message or bundle"}, sender);
        }
    }
}

void Endpoint::handle(const Command& command) {
    if (const auto* wish = std::get_if<Subscribe>(&command)) return subscribe(*wish);
    if (const auto* ask = std::get_if<Ping>(&command)) return answer(ask->asker, "/pong", {});
    if (const auto* ask = std::get_if<Describe>(&command)) return describe(ask->asker);
    if (const auto* wish = std::get_if<Unsubscribe>(&command)) return remove(wish->peer);
    const std::lock_guard lock(mutex_);
    if (commands_.size() < kMostCommands) commands_.push_back(command);
}

void Endpoint::subscribe(const Subscribe& wish) {
    try {
        const sockaddr_in address = UdpSocket::resolve(wish.peer.host, wish.peer.port);
        remove(UdpSocket::peer(address));
        const std::lock_guard lock(mutex_);
        if (subscribers_.size() >= kMostSubscribers) {
            throw std::runtime_error("no more than 32 subscribers");
        }
        subscribers_.push_back({UdpSocket::peer(address), address, wish.feed});
    } catch (const std::runtime_error& error) {
        refuse({"/subscribe", error.what()}, wish.asker);
    }
}

void Endpoint::remove(const Peer& peer) {
    Peer numeric = peer;
    try {
        numeric = UdpSocket::peer(UdpSocket::resolve(peer.host, peer.port));
    } catch (const std::runtime_error&) {
        // A name that cannot be looked up any more cannot be told from others: nothing to remove.
    }
    const std::lock_guard lock(mutex_);
    std::erase_if(subscribers_, [&](const Subscriber& s) { return s.peer == numeric; });
}

void Endpoint::describe(const Peer& asker) {
    for (const Address& address : address_table()) {
        answer(asker, "/description", {address.path, usage(address), address.description});
    }
}

void Endpoint::refuse(const Refusal& refusal, const Peer& sender) {
    answer(sender, "/error", {refusal.address, refusal.reason});
}

void Endpoint::answer(const Peer& asker, const std::string& address,
                      std::vector<std::string> texts) {
    try {
        socket_.send(encode_text(address, texts), UdpSocket::resolve(asker.host, asker.port));
    } catch (const std::runtime_error&) {
        // The asker's address came from its own packet; if it is gone there is nobody to tell.
    }
}

void Endpoint::send_loop() {
    next_clock_ = wall_();
    while (true) {
        std::deque<Outgoing> batch;
        {
            std::unique_lock lock(mutex_);
            double due = next_clock_;
            if (!repeats_.empty()) due = std::min(due, repeats_.front().wall);
            const double wait = std::max(0.0, due - wall_());
            wake_.wait_for(lock, std::chrono::duration<double>(wait),
                           [this] { return stopping_ || !outgoing_.empty(); });
            if (stopping_ && outgoing_.empty()) return;
            batch.swap(outgoing_);
        }
        for (const Outgoing& message : batch) send(message);
        send_due(wall_());
    }
}

void Endpoint::send_due(double now) {
    while (!repeats_.empty() && repeats_.front().wall <= now) {
        broadcast(repeats_.front().packet, Feed::sound);
        repeats_.pop_front();
    }
    if (now >= next_clock_) {
        broadcast(encode_clock(now, options_.lookahead), Feed::sound);
        next_clock_ = std::max(next_clock_ + kClockInterval, now);
    }
}

void Endpoint::send_contact(const ContactMessage& contact) {
    const std::vector<ContactMessage> earlier(recent_.begin(), recent_.end());
    Packet packet = encode(contact, earlier, options_.lookahead);
    broadcast(packet, Feed::sound);
    const double now = wall_();
    const double gap = kRepeatShare * options_.lookahead;
    for (int i = 1; i <= kRepeats; ++i) repeats_.push_back({now + i * gap, packet});
    std::sort(repeats_.begin(), repeats_.end(),
              [](const Repeat& a, const Repeat& b) { return a.wall < b.wall; });
    recent_.push_front(contact);
    if (recent_.size() > kRideAlong) recent_.pop_back();
}

void Endpoint::send(const Outgoing& message) {
    const double lookahead = options_.lookahead;
    if (const auto* contact = std::get_if<ContactMessage>(&message)) {
        send_contact(*contact);
    } else if (const auto* pose = std::get_if<PoseMessage>(&message)) {
        broadcast(encode(*pose, lookahead), Feed::pose);
    } else if (const auto* scene = std::get_if<SceneMessage>(&message)) {
        broadcast(encode(*scene, lookahead), Feed::pose);
    } else if (const auto* status = std::get_if<StatusMessage>(&message)) {
        broadcast(encode(*status, subscribers(), lookahead), Feed::all);
    } else if (const auto* finished = std::get_if<FinishedMessage>(&message)) {
        broadcast(encode(*finished, lookahead), Feed::all);
    } else {
        broadcast(encode(std::get<ErrorMessage>(message)), Feed::all);
    }
}

void Endpoint::broadcast(const Packet& packet, Feed feed) {
    std::array<sockaddr_in, kMostSubscribers> to;
    std::size_t count = 0;
    {
        const std::lock_guard lock(mutex_);
        for (const Subscriber& s : subscribers_) {
            const int wanted = static_cast<int>(s.feed) & static_cast<int>(feed);
            if (wanted != 0) to[count++] = s.address;
        }
    }
    for (std::size_t i = 0; i < count; ++i) socket_.send(packet, to[i]);
}

}  // namespace percussionist::osc
