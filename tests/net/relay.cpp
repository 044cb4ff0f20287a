#include "net/relay.hpp"

#include <poll.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>

#include "io/monotonic.hpp"

namespace percussionist::test {

namespace {

constexpr double kLongestWait = 0.05;  // [s]

struct Waiting {
    double due = 0.0;
    std::uint64_t serial = 0;
    io::Bytes bytes;
    bool operator<(const Waiting& other) const {
        return due != other.due ? due > other.due : serial > other.serial;
    }
};

void wait(int handle, double seconds) {
    pollfd readable{handle, POLLIN, 0};
    const double limited = std::clamp(seconds, 0.0, kLongestWait);
    const timespec time{0, std::lround(1e9 * limited)};
    ppoll(&readable, 1, &time, nullptr);
}

}  // namespace

Relay::Relay(int port, const io::Endpoint& to, const RelaySettings& settings,
             const std::string& address)
    : socket_(address, port), to_(to), settings_(settings), thread_([this] { run(); }) {}

Relay::~Relay() {
    ending_ = true;
    thread_.join();
}

void Relay::run() {
    prctl(PR_SET_TIMERSLACK, 1);
    std::mt19937_64 random(settings_.seed);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    std::priority_queue<Waiting> waiting;
    std::uint64_t serial = 0;
    const auto take = [&](std::span<const std::uint8_t> bytes, const io::Endpoint&, double now) {
        for (int copies = chance(random) < settings_.doubled ? 2 : 1; copies > 0; --copies) {
            const double due = now + settings_.delay + settings_.jitter * chance(random);
            if (chance(random) >= settings_.loss && !cut_) {
                waiting.push({due, serial++, {bytes.begin(), bytes.end()}});
            }
        }
    };
    while (!ending_ || !waiting.empty()) {
        wait(socket_.handle(),
             waiting.empty() ? kLongestWait : waiting.top().due - io::monotonic_seconds());
        while (socket_.receive(take)) {
        }
        for (const double now = io::monotonic_seconds();
             !waiting.empty() && waiting.top().due <= now; waiting.pop()) {
            socket_.send(to_, waiting.top().bytes);
        }
    }
}

}  // namespace percussionist::test
