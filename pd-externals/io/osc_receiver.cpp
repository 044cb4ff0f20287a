#include "io/osc_receiver.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <utility>

#include "io/monotonic.hpp"

namespace percussionist::io {

namespace {

constexpr double kOften = 1.0;                    // [s]
constexpr int kLongestWait = 50;                  // [ms]
constexpr std::size_t kMostToSend = 256;          // while a host's name is looked up
constexpr double kFrom1900To1970 = 2208988800.0;  // [s]

}  // namespace

OscReceiver::OscReceiver(const std::string& address, int port, Naming naming)
    : socket_(address, port),
      inbox_([this](std::unique_ptr<Delivery> delivery) { hand_over(std::move(delivery)); }),
      waker_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      naming_(std::move(naming)),
      thread_([this] { run(); }) {}

OscReceiver::~OscReceiver() {
    ending_ = true;
    wake();
    thread_.join();
    close(waker_);
}

std::unique_ptr<Delivery> OscReceiver::next() noexcept {
    std::unique_ptr<Delivery> delivery;
    deliveries_.pop(delivery);
    return delivery;
}

void OscReceiver::give_back(std::unique_ptr<Delivery> delivery) noexcept {
    returned_.push(std::move(delivery));
}

OscReceiver::Status OscReceiver::status() const noexcept {
    std::array<double, kNumbers> numbers{};
    for (std::size_t i = 0; i < kNumbers; ++i) {
        numbers[i] = status_[i].load(std::memory_order_relaxed);
    }
    return std::bit_cast<Status>(numbers);
}

void OscReceiver::set_server(const std::string& host, int port) {
    command({.kind = Command::Kind::kServer, .host = host, .port = port, .packet = {}});
}

void OscReceiver::send(Bytes packet) {
    command({.kind = Command::Kind::kSend, .host = {}, .packet = std::move(packet)});
}

void OscReceiver::send_often(Bytes packet) {
    command({.kind = Command::Kind::kOften, .host = {}, .packet = std::move(packet)});
}

void OscReceiver::find() {
    command({.kind = Command::Kind::kFind, .host = {}, .packet = {}});
}

void OscReceiver::command(Command command) {
    if (!commands_.push(std::move(command))) {
        throw std::runtime_error("too much to send at once");
    }
    wake();
}

void OscReceiver::wake() const noexcept {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(waker_, &one, sizeof one);
}

void OscReceiver::run() {
    const auto take = [this](auto bytes, const Endpoint& from, double arrival) {
        inbox_.take(bytes, from, arrival);
    };
    for (bool ending = false; !ending;) {
        wait();
        ending = ending_;
        while (socket_.receive(take)) {
        }
        publish_status();
        obey_commands();
        if (ending && !last_.empty()) {
            often_.clear();
            to_send_.push_back(std::move(last_));
        }
        send_what_waits(monotonic_seconds());
        search(monotonic_seconds());
        for (std::unique_ptr<Delivery> done; returned_.pop(done);) {
        }
    }
}

/// For a packet, a command, or a short time.
void OscReceiver::wait() const {
    std::array<pollfd, 2> handles{{{socket_.handle(), POLLIN, 0}, {waker_, POLLIN, 0}}};
    if (poll(handles.data(), handles.size(), kLongestWait) > 0 && handles[1].revents != 0) {
        std::uint64_t count = 0;
        [[maybe_unused]] const auto size = read(waker_, &count, sizeof count);
    }
}

void OscReceiver::obey_commands() {
    for (Command command; commands_.pop(command);) {
        obey(command);
    }
}

void OscReceiver::obey(Command& command) {
    switch (command.kind) {
        case Command::Kind::kServer:
            send_what_waits(monotonic_seconds());  // to the one before
            head_for(command.host, static_cast<std::uint16_t>(command.port));
            break;
        case Command::Kind::kOften:
            often_ = std::move(command.packet);
            sent_often_ = -kOften;
            break;
        case Command::Kind::kSend:
            if (to_send_.size() == kMostToSend) {
                to_send_.pop_front();
            }
            to_send_.push_back(std::move(command.packet));
            break;
        case Command::Kind::kFind:
            search_.emplace(monotonic_seconds());
            break;
    }
}

void OscReceiver::search(double now) {
    if (!search_) {
        return;
    }
    for (FoundServer& server : search_->step(now)) {
        auto delivery = std::make_unique<Delivery>();
        delivery->found = std::move(server);
        hand_over(std::move(delivery));
    }
    if (search_->over(now)) {
        if (search_->in_vain()) {
            complain(
                "find: no server has answered within 3 s; expected one that was started with "
                "--listen 0.0.0.0 on a machine with the Avahi daemon");
        }
        search_.reset();
    }
}

void OscReceiver::head_for(const std::string& host, std::uint16_t port) {
    if (host != server_name_ || port != server_.port) {
        to_send_.clear();  // it was meant for the one before
    }
    server_name_ = host;
    server_ = {0, port};
    lookup_.emplace(host, naming_.ask);
    unknown_ = false;
}

/// Looks it up, if there is anything to send to it.
bool OscReceiver::knows_server(double now) {
    if (server_.address != 0) {
        return true;
    }
    const bool wanted = !often_.empty() || !to_send_.empty();
    if (!lookup_ && wanted && !server_name_.empty() && now >= look_up_at_) {
        lookup_.emplace(server_name_, naming_.ask);
    }
    if (!lookup_ || !lookup_->done()) {
        return false;
    }
    server_.address = lookup_->address();
    lookup_.reset();
    if (server_.address != 0) {
        return true;
    }
    look_up_at_ = now + naming_.again;
    if (!unknown_ || !to_send_.empty()) {
        complain("no host " + server_name_);
    }
    unknown_ = true;
    to_send_.clear();
    return false;
}

void OscReceiver::send_what_waits(double now) {
    if (!knows_server(now)) {
        return;
    }
    if (!often_.empty() && now - sent_often_ >= kOften) {
        sent_often_ = now;
        to_send_.push_back(often_);
    }
    for (; !to_send_.empty(); to_send_.pop_front()) {
        const int wrong = socket_.send(server_, to_send_.front()) ? 0 : errno;
        if (wrong != 0 && wrong != last_wrong_) {  // said once, however long a cable is out
            complain("not sent to " + server_name_ + ": " + std::strerror(wrong));
        }
        last_wrong_ = wrong;
    }
}

void OscReceiver::hand_over(std::unique_ptr<Delivery> delivery) {
    if (!deliveries_.push(std::move(delivery))) {
        ++refused_;
    }
}

void OscReceiver::complain(const std::string& text) {
    auto delivery = std::make_unique<Delivery>();
    delivery->complaint = text;
    hand_over(std::move(delivery));
}

void OscReceiver::publish_status() {
    Status status{inbox_.status(), refused_ + socket_.dropped()};
    if (status.offset != 0.0) {
        status.offset += read_clock(CLOCK_REALTIME) - monotonic_seconds() + kFrom1900To1970;
    }
    const auto numbers = std::bit_cast<std::array<double, kNumbers>>(status);
    for (std::size_t i = 0; i < kNumbers; ++i) {
        status_[i].store(numbers[i], std::memory_order_relaxed);
    }
}

}  // namespace percussionist::io
