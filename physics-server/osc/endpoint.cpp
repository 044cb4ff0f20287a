#include "osc/endpoint.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace percussionist::osc {

namespace {

/// How many events ride along: with them a packet still fits one Ethernet frame.
constexpr std::size_t kRideAlong = 7;
/// What may not be lost is sent again evenly over half of the lookahead, for that much is surely
/// left when a contact is known: the more often, the longer that is.
constexpr double kRepeatShare = 0.5;
constexpr double kRepeatsApart = 7.5e-3;  // [s]
constexpr int kLeastRepeats = 4;
constexpr int kMostRepeats = 12;
constexpr double kClockInterval = 0.01;
/// Commands not yet taken beyond this many are refused: memory is bounded.
constexpr std::size_t kMostCommands = 256;
constexpr std::size_t kCommandsAtOnce = 2;
/// What waits to be sent: of poses and scenes the newest few, of all else no more than this.
constexpr std::size_t kMostPictures = 8;
constexpr std::size_t kMostOutgoing = 16384;
/// Of one picture, by routes: so that strokes never wait long for poses.
constexpr std::size_t kMostRoutedPoses = 400;
constexpr double kCheckInterval = 0.1;  // of silent subscribers [s]

bool is_picture(const Outgoing& message) {
    return std::holds_alternative<PoseMessage>(message) ||
           std::holds_alternative<SceneMessage>(message) ||
           std::holds_alternative<ObjectsMessage>(message);
}

}  // namespace

Endpoint::Endpoint(const EndpointOptions& options, std::function<double()> wall)
    : options_(options), wall_(std::move(wall)), socket_(options.listen, options.port) {
    for (const std::string& host : options.allow) {
        allowed_.push_back(UdpSocket::resolve(host, "1").sin_addr.s_addr);
    }
    for (const std::string& line : options.routes) {
        const Route route = parse_route(line);
        audience_.add_route(route, UdpSocket::resolve(route.to.host, route.to.port));
    }
    hearing_ = std::thread([this] { hear(); });
    sending_ = std::thread([this] { send_loop(); });
}

Endpoint::~Endpoint() {
    {
        const std::lock_guard lock(outgoing_mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    hearing_.join();
    sending_.join();
}

void Endpoint::tell(Outgoing message) {
    {
        const std::lock_guard lock(outgoing_mutex_);
        if (is_picture(message)) {
            if (pictures_.size() >= kMostPictures) pictures_.pop_front();
            pictures_.push_back(std::move(message));
        } else if (outgoing_.size() < kMostOutgoing) {
            outgoing_.push_back(std::move(message));
        }
    }
    wake_.notify_one();
}

std::vector<Heard> Endpoint::take_commands() {
    const std::unique_lock lock(commands_mutex_, std::try_to_lock);
    if (!lock) return {};  // they wait for the next step
    const auto end = commands_.begin() +
                     static_cast<std::ptrdiff_t>(std::min(commands_.size(), kCommandsAtOnce));
    std::vector<Heard> taken(std::move_iterator(commands_.begin()), std::move_iterator(end));
    commands_.erase(commands_.begin(), end);
    return taken;
}

void Endpoint::hear() {
    std::array<char, 65536> buffer;
    constexpr int kCheckStopping = 50;
    while (true) {
        const auto received = socket_.receive(buffer, kCheckStopping);
        if (stopping_) return;
        drop_silent();
        drop_unreachable();
        if (received) hear({buffer.data(), received->size}, received->from);
    }
}

void Endpoint::hear(std::span<const char> packet, const sockaddr_in& from) {
    const Peer sender = UdpSocket::peer(from);
    const double wall = wall_();
    const auto message = [&](const std::string& path, std::span<const Argument> arguments,
                             std::optional<double> tag) {
        // Two servers that are told of each other must not complain to each other for ever.
        if (path == "/error") return;
        const auto said = understand(path, arguments);
        if (const auto* refusal = std::get_if<Refusal>(&said)) {
            refuse(*refusal, sender);
        } else if (const auto& command = std::get<Command>(said); !handled(command, sender)) {
            const std::lock_guard lock(commands_mutex_);
            if (commands_.size() >= kMostCommands) return;
            commands_.push_back(
                {command, path, {arguments.begin(), arguments.end()}, sender, wall, tag});
        }
    };
    if (!decode_tagged(packet, message)) {
        refuse({"packet", "expected an OSC message or bundle"}, sender);
    }
}

bool Endpoint::handled(const Command& command, const Peer& asker) {
    return std::visit(
        [&](const auto& wish) {
            constexpr bool own = requires {
                handle(wish, asker);
            };
            if constexpr (own) handle(wish, asker);
            return own;
        },
        command);
}

/// In numbers, or by a name that was given to --allow: to look others up takes seconds, in which
/// nobody would be heard.
in_addr_t Endpoint::known_host(const std::string& host) const {
    if (const auto numeric = UdpSocket::numeric(host)) return *numeric;
    const auto named = std::find(options_.allow.begin(), options_.allow.end(), host);
    if (named == options_.allow.end()) {
        throw std::runtime_error(host.substr(0, 80) +
                                 ": not allowed; expected an address in numbers, or a host given "
                                 "with --allow");
    }
    return allowed_[static_cast<std::size_t>(named - options_.allow.begin())];
}

sockaddr_in Endpoint::allowed_target(const Peer& to, const Peer& asker) const {
    const in_addr_t host = known_host(to.host.empty() ? asker.host : to.host);
    constexpr std::uint32_t kLoopback = 127;
    const bool allowed = ntohl(host) >> 24U == kLoopback || host == known_host(asker.host) ||
                         std::find(allowed_.begin(), allowed_.end(), host) != allowed_.end();
    if (!allowed) {
        throw std::runtime_error(to.host +
                                 ": not allowed; expected this machine, the asker's, or a "
                                 "host given with --allow");
    }
    return UdpSocket::address(host, to.port);
}

void Endpoint::handle(const Subscribe& wish, const Peer& asker) {
    try {
        audience_.subscribe(allowed_target(wish.peer, asker), wish.feed, wall_());
    } catch (const std::runtime_error& error) {
        refuse({"/subscribe", error.what()}, asker);
    }
}

void Endpoint::handle(const Unsubscribe& wish, const Peer& asker) {
    try {
        audience_.drop(allowed_target(wish.peer, asker));
    } catch (const std::runtime_error& error) {
        refuse({"/unsubscribe", error.what()}, asker);
    }
}

void Endpoint::handle(const AddRoute& wish, const Peer& asker) {
    try {
        const Route route = parse_route(wish.line);
        const int number = audience_.add_route(route, allowed_target(route.to, asker));
        answer(asker, "/route", {std::to_string(number), to_string(route)});
    } catch (const std::exception& error) {
        refuse({"/route/add", error.what()}, asker);
    }
}

void Endpoint::handle(const ChangeRoute& wish, const Peer& asker) {
    try {
        const Route route = parse_route(wish.line);
        if (!audience_.change_route(wish.number, route, allowed_target(route.to, asker))) {
            throw std::runtime_error("no route " + std::to_string(wish.number));
        }
        answer(asker, "/route", {std::to_string(wish.number), to_string(route)});
    } catch (const std::exception& error) {
        refuse({"/route/change", error.what()}, asker);
    }
}

void Endpoint::handle(const RemoveRoute& wish, const Peer& asker) {
    const std::string number = std::to_string(wish.number);
    if (audience_.remove_route(wish.number)) {
        answer(asker, "/reply", {"/route/remove", number});
    } else {
        refuse({"/route/remove", "no route " + number}, asker);
    }
}

void Endpoint::handle(const ListRoutes&, const Peer& asker) {
    for (const auto& [number, line] : audience_.routes()) {
        answer(asker, "/route", {std::to_string(number), line});
    }
}

void Endpoint::handle(const Ping&, const Peer& asker) {
    answer(asker, "/pong", {});
}

void Endpoint::handle(const Describe&, const Peer& asker) {
    for (const Address& address : address_table()) {
        answer(asker, "/description", {address.path, usage(address), address.description});
    }
}

void Endpoint::drop_unreachable() {
    while (const auto gone = socket_.unreachable()) {
        if (!audience_.drop(*gone)) continue;
        const Peer peer = UdpSocket::peer(*gone);
        tell(DroppedMessage{peer.host, peer.port});
    }
}

void Endpoint::drop_silent() {
    const double now = wall_();
    if (now < next_check_) return;
    next_check_ = now + kCheckInterval;
    for (const Peer& peer : audience_.drop_silent(now)) {
        tell(DroppedMessage{peer.host, peer.port});
    }
}

void Endpoint::refuse(const Refusal& refusal, const Peer& sender) {
    answer(sender, "/error", {refusal.address, refusal.reason});
}

void Endpoint::answer(const Peer& asker, const std::string& address,
                      std::vector<std::string> texts) {
    if (asker.host.empty()) return;
    const sockaddr_in to = UdpSocket::address(known_host(asker.host), asker.port);
    {
        const std::lock_guard lock(answers_mutex_);
        if (!answers_.allows(to.sin_addr.s_addr, wall_())) return;
    }
    socket_.send(encode_text(address, texts), to);
}

void Endpoint::send_loop() {
    options_.before_sending();
    next_clock_ = wall_();
    while (true) {
        std::deque<Outgoing> batch;
        std::optional<Outgoing> picture;
        {
            std::unique_lock lock(outgoing_mutex_);
            double due = next_clock_;
            if (!repeats_.empty()) due = std::min(due, repeats_.front().wall);
            const double wait = std::max(0.0, due - wall_());
            wake_.wait_for(lock, std::chrono::duration<double>(wait), [this] {
                return stopping_ || !outgoing_.empty() || !pictures_.empty();
            });
            if (stopping_ && outgoing_.empty()) break;
            batch.swap(outgoing_);
            if (batch.empty() && !pictures_.empty()) {
                picture = std::move(pictures_.front());
                pictures_.pop_front();
            }
        }
        for (const Outgoing& message : batch) send(message);
        send_due(wall_());
        if (picture) send_picture(*picture);
    }
    for (const Repeat& repeat : repeats_) broadcast(repeat.packet, repeat.feed);
}

void Endpoint::send_due(double now) {
    while (!repeats_.empty() && repeats_.front().wall <= now) {
        broadcast(repeats_.front().packet, repeats_.front().feed);
        repeats_.pop_front();
    }
    if (now >= next_clock_) {
        broadcast(encode_clock(now, options_.lookahead), Feed::sound);
        next_clock_ = std::max(next_clock_ + kClockInterval, now);
    }
}

void Endpoint::send_contact(const ContactMessage& contact) {
    const std::vector<ContactMessage> earlier(recent_.begin(), recent_.end());
    send_repeatedly(encode(contact, earlier, options_.lookahead), Feed::sound);
    recent_.push_front(contact);
    if (recent_.size() > kRideAlong) recent_.pop_back();
}

void Endpoint::send_repeatedly(const Packet& packet, Feed feed) {
    broadcast(packet, feed);
    const double now = wall_();
    const double over = kRepeatShare * options_.lookahead;
    const int repeats =
        std::clamp(static_cast<int>(over / kRepeatsApart), kLeastRepeats, kMostRepeats);
    const double gap = over / repeats;
    for (int i = 1; i <= repeats; ++i) repeats_.push_back({now + i * gap, packet, feed});
    std::sort(repeats_.begin(), repeats_.end(),
              [](const Repeat& a, const Repeat& b) { return a.wall < b.wall; });
}

void Endpoint::send(const Outgoing& message) {
    const double lookahead = options_.lookahead;
    if (const auto* contact = std::get_if<ContactMessage>(&message)) {
        send_contact(*contact);
        send_routed(event_of(*contact));
    } else if (const auto* strike = std::get_if<StrikeMessage>(&message)) {
        send_routed(event_of(*strike));
    } else if (const auto* status = std::get_if<StatusMessage>(&message)) {
        broadcast(encode(*status, subscribers(), lookahead), Feed::all);
        send_routed(event_of(*status));
    } else if (const auto* state = std::get_if<StateMessage>(&message)) {
        broadcast(encode(*state, lookahead), Feed::all);
    } else if (const auto* started = std::get_if<StartedMessage>(&message)) {
        send_repeatedly(encode(*started, lookahead), Feed::all);
    } else if (const auto* finished = std::get_if<FinishedMessage>(&message)) {
        send_repeatedly(encode(*finished, lookahead), Feed::all);
    } else if (const auto* dropped = std::get_if<DroppedMessage>(&message)) {
        broadcast(encode(*dropped), Feed::all);
    } else if (const auto* kit = std::get_if<KitMessage>(&message)) {
        broadcast(encode(*kit, lookahead), Feed::all);
    } else if (const auto* tick = std::get_if<TickMessage>(&message)) {
        broadcast(encode(*tick, lookahead), Feed::sound);
    } else if (const auto* noted = std::get_if<NotedMessage>(&message)) {
        broadcast(encode(*noted, lookahead), Feed::all);
    }
}

void Endpoint::send_picture(const Outgoing& message) {
    if (const auto* scene = std::get_if<SceneMessage>(&message)) {
        broadcast(encode(*scene, options_.lookahead), Feed::pose);
        return;
    }
    if (const auto* objects = std::get_if<ObjectsMessage>(&message)) {
        broadcast(encode(*objects, options_.lookahead), Feed::pose);
        return;
    }
    const auto& pose = std::get<PoseMessage>(message);
    broadcast(encode(pose, options_.lookahead), Feed::pose);
    if (!audience_.wanted(EventKind::pose)) return;
    std::size_t sent = 0;
    for (const BodyPose& body : pose.bodies) {
        if (sent >= kMostRoutedPoses) return;
        sent += send_routed(event_of(body, pose.wall));
    }
}

/// Returns how many packets that made.
std::size_t Endpoint::send_routed(const Event& event) {
    std::size_t sent = 0;
    audience_.route(event, [&](const Route& route, const sockaddr_in& to) {
        ++sent;
        const std::vector<Argument> values = arguments(route, event);
        socket_.send(encode_routed(route.address, values, event.wall + options_.lookahead), to);
    });
    return sent;
}

void Endpoint::broadcast(const Packet& packet, Feed feed) {
    Audience::Addresses to;
    const std::size_t count = audience_.listeners(feed, to);
    for (std::size_t i = 0; i < count; ++i) socket_.send(packet, to[i]);
}

}  // namespace percussionist::osc
