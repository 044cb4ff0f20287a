// flood_report SERVER [RATE SECONDS]: floods a server's port with packets (commands, questions,
// rubbish; 100,000 a second for 10 s unless told otherwise) while it plays, and prints what becomes
// of its simulation, its memory and the others it serves. Fails where it stops, grows beyond 64 MB
// more than before, or answers nobody afterwards.
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "io/monotonic.hpp"
#include "io/osc_packet.hpp"
#include "io/udp_socket.hpp"
#include "net/process.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist;
using namespace percussionist::test;

namespace {

constexpr std::uint32_t kHere = 0x7F000001;
constexpr std::size_t kBatch = 64;

/// Half commands and questions that are understood, half what is not.
std::vector<OscBytes> packets() {
    return {osc_message("/tempo", "f", {osc_float(1.0)}),
            osc_message("/describe", "", {}),
            osc_message("/route/list", "", {}),
            osc_message("/nonsense", "i", {osc_int(1)}),
            OscBytes(1400, 'x'),
            osc_message("/route/add", "s", {osc_text("pose to 127.0.0.1:9 /x")}),
            osc_message("/route/remove", "i", {osc_int(1)}),
            rich_packet()};
}

/// Sends at a rate until then; returns how many.
std::size_t flood(std::uint16_t port, double rate, double seconds) {
    const int handle = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(kHere);
    to.sin_port = htons(port);
    connect(handle, reinterpret_cast<sockaddr*>(&to), sizeof to);
    auto all = packets();
    std::vector<iovec> parts(kBatch);
    std::vector<mmsghdr> headers(kBatch);
    for (std::size_t i = 0; i < kBatch; ++i) {
        auto& packet = all[i % all.size()];
        parts[i] = {packet.data(), packet.size()};
        headers[i].msg_hdr.msg_iov = &parts[i];
        headers[i].msg_hdr.msg_iovlen = 1;
    }
    const double begin = io::monotonic_seconds();
    std::size_t sent = 0;
    for (double now = begin; now < begin + seconds; now = io::monotonic_seconds()) {
        while (static_cast<double>(sent) < rate * (now - begin) && now < begin + seconds) {
            const int count = sendmmsg(handle, headers.data(), kBatch, MSG_DONTWAIT);
            sent += count > 0 ? static_cast<std::size_t>(count) : 0;
            now = io::monotonic_seconds();
        }
        usleep(200);
    }
    close(handle);
    return sent;
}

/// Of a process, resident [MB].
double memory(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/statm");
    double pages = 0.0, resident = 0.0;
    file >> pages >> resident;
    return resident * 4096.0 / 1e6;
}

/// What /status tells last, and how many contacts came.
class Client {
  public:
    explicit Client(std::uint16_t server) : server_{kHere, server}, thread_([this] { hear(); }) {}
    ~Client() {
        ending_ = true;
        thread_.join();
    }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    void send(const OscBytes& packet) { socket_.send(server_, packet); }
    double time() const { return time_; }
    double late() const { return late_; }
    int contacts() const { return contacts_; }
    int pongs() const { return pongs_; }

  private:
    void subscribe() {
        socket_.send(server_,
                     osc_message("/subscribe", "is", {osc_int(socket_.port()), osc_text("sound")}));
    }
    void hear() {
        for (double renewed = 0.0; !ending_;) {
            if (io::monotonic_seconds() > renewed + 1.0) {
                renewed = io::monotonic_seconds();
                subscribe();
            }
            socket_.receive([this](auto bytes, const io::Endpoint&, double) { take(bytes); });
            usleep(500);
        }
    }
    void take(std::span<const std::uint8_t> bytes) {
        for (const auto& bundle : io::read_osc(bytes).bundles) {
            for (const auto& message : bundle.messages) {
                if (message.address == "/status") {
                    time_ = std::get<double>(message.arguments.at(0));
                    late_ = std::get<double>(message.arguments.at(2));
                } else if (message.address == "/contact") {
                    contacts_ =
                        std::max(contacts_.load(),
                                 1 + static_cast<int>(std::get<double>(message.arguments.at(0))));
                } else if (message.address == "/pong") {
                    ++pongs_;
                }
            }
        }
    }

    io::UdpSocket socket_{"127.0.0.1", 0};
    io::Endpoint server_;
    std::atomic<double> time_{0.0}, late_{0.0};
    std::atomic<int> contacts_{0}, pongs_{0};
    std::atomic<bool> ending_{false};
    std::thread thread_;
};

template <class Condition>
bool within(double seconds, Condition condition) {
    for (const double end = io::monotonic_seconds() + seconds; io::monotonic_seconds() < end;) {
        if (condition()) {
            return true;
        }
        usleep(2000);
    }
    return false;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) {
        std::cerr << "flood_report SERVER [RATE SECONDS]\n";
        return 2;
    }
    const double rate = count > 2 ? std::atof(arguments[2]) : 1e5;
    const double seconds = count > 3 ? std::atof(arguments[3]) : 10.0;
    const int port = free_port();
    const Process server({arguments[1], "serve", "--play", "--port", std::to_string(port)});
    if (!wait_for_listener(port)) {
        return 1;
    }
    Client client(static_cast<std::uint16_t>(port));
    const bool served = within(10.0, [&] { return client.time() > 1.0; });
    const double before = memory(server.id());
    const double late = client.late(), contacts = client.contacts(), simulated = client.time();
    const double began = io::monotonic_seconds();
    const std::size_t sent = flood(static_cast<std::uint16_t>(port), rate, seconds);
    const double lasted = io::monotonic_seconds() - began;
    const double after = memory(server.id());
    const double flooded = client.time();
    const bool answered = within(10.0, [&] {
        client.send(osc_message("/ping", "", {}));
        return client.pongs() > 0;
    });
    const bool goes_on = within(5.0, [&] { return client.time() > flooded + 1.5; });
    std::printf("%zu packets in %.1f s, %.0f a second\n", sent, lasted,
                static_cast<double>(sent) / lasted);
    std::printf("simulated meanwhile  %.1f s, late steps %.0f, contacts heard %.0f\n",
                flooded - simulated, client.late() - late, client.contacts() - contacts);
    std::printf("simulated, to then   %.1f s in %.1f s\n", client.time() - simulated,
                io::monotonic_seconds() - began);
    std::printf("memory               %.1f MB before, %.1f MB after\n", before, after);
    std::printf("afterwards           %s, %s\n", answered ? "answers" : "answers nobody",
                goes_on ? "goes on" : "has stopped");
    constexpr double kMostGrowth = 64.0;  // [MB]
    return served && answered && goes_on && after < before + kMostGrowth ? 0 : 1;
}
