// osc_receive_report PD EXTERNALS PATCHES [--laws]: a sender as docs/osc-protocol.md has it, a bad
// network and a real Pd, in real time; prints how evenly [osc-receive] lets contacts out. With
// --laws, shorter, and it fails if any contact is lost, doubled or out of order.
#include <signal.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "io/monotonic.hpp"
#include "io/udp_socket.hpp"
#include "net/process.hpp"
#include "net/relay.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist;
using namespace percussionist::test;

namespace {

constexpr double kLookahead = 0.03;
constexpr double kRate = 48000.0;
constexpr double kSettling = 2.0;  // what is measured begins that much after the first [s]
constexpr std::uint32_t kHere = 0x7F000001;

struct Scenario {
    std::string name;
    double seconds = 10.0;
    RelaySettings network = {};
    double drift = 0.0;
    double stop_at = -1.0;  // Pd stands still from then on for half a second
    int burst = 0;          // contacts at once instead
    double clocks = 20.0;   // a second
};

struct Note {
    double logical = 0.0;
    int number = 0;
};

struct Result {
    std::vector<double> instants;  // monotonic
    std::vector<Note> notes;
    double continued = 0.0;  // when Pd was let go on
    bool ended = false;
};

void sleep_until(double time) {
    const timespec until{static_cast<time_t>(time),
                         std::lround(1e9 * (time - std::floor(time))) % 1000000000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

/// What a sender does when, by the monotonic clock.
class Agenda {
  public:
    void at(double time, std::function<void()> action) {
        actions_.emplace(time, std::move(action));
    }
    void run() {
        for (; !actions_.empty(); actions_.erase(actions_.begin())) {
            sleep_until(actions_.begin()->first);
            actions_.begin()->second();
        }
    }

  private:
    std::multimap<double, std::function<void()>> actions_;
};

std::vector<double> instants(const Scenario& scenario, double from) {
    std::vector<double> all;
    std::mt19937_64 random(scenario.network.seed);
    std::uniform_real_distribution<double> apart(0.005, 0.015);
    const double end = from + scenario.seconds;
    for (double t = from; scenario.burst > 0 ? static_cast<int>(all.size()) < scenario.burst
                          : t<end; t += scenario.burst> 0 ? 0.0
                                                          : apart(random)) {
        all.push_back(t);
    }
    return all;
}

std::vector<Note> read_notes(const std::string& path) {
    std::ifstream file(path);
    std::vector<Note> notes;
    for (Note note; file >> note.logical >> note.number;) {
        notes.push_back(note);
    }
    return notes;
}

Result play(const Scenario& scenario, char** arguments) {
    const int port = free_port();
    const std::string path = "/tmp/osc_receive_notes." + std::to_string(getpid());
    Process pd(pd_command(arguments[1],
                          {"-path", arguments[2], "-path", std::string(arguments[2]) + "/../net",
                           "-open", std::string(arguments[3]) + "/receive.pd", "-send",
                           "osc-port port " + std::to_string(port)}));
    Result result;
    if (!wait_for_listener(port)) {
        return result;
    }
    const io::Endpoint there{kHere, static_cast<std::uint16_t>(port)};
    const io::UdpSocket socket("127.0.0.1", 0);
    const Relay relay(0, there, scenario.network);
    const io::Endpoint by_relay{kHere, static_cast<std::uint16_t>(relay.port())};
    const double begin = io::monotonic_seconds();
    const auto sender_clock = [&](double t) { return (t - begin) * (1.0 + scenario.drift); };

    Agenda agenda;
    result.instants = instants(scenario, begin + 1.0);
    const double end = result.instants.back() + 0.5;
    for (double t = begin; t < end; t += 1.0 / scenario.clocks) {
        agenda.at(t, [&] {
            socket.send(by_relay, clock_packet(sender_clock(io::monotonic_seconds()), kLookahead));
        });
    }
    for (std::size_t i = 0; i < result.instants.size(); ++i) {
        std::vector<Contact> contacts;
        for (std::size_t k = i + 1; k > (i > 7 ? i - 7 : 0); --k) {
            contacts.push_back({static_cast<int>(k) - 1, sender_clock(result.instants[k - 1])});
        }
        const auto packet = contact_packet(contacts, kLookahead);
        for (int again = 0; again < (scenario.burst > 0 ? 1 : 5); ++again) {
            agenda.at(result.instants[i] + 0.008 + 0.00375 * again,
                      [&, packet] { socket.send(by_relay, packet); });
        }
    }
    if (scenario.stop_at > 0.0) {
        const double stop = begin + 1.0 + scenario.stop_at;
        result.continued = stop + 0.5;
        agenda.at(stop, [&] { pd.signal(SIGSTOP); });
        agenda.at(stop + 0.5, [&] { pd.signal(SIGCONT); });
    }
    for (int again = 0; again < 10; ++again) {
        agenda.at(end + 0.05 * again,
                  [&] { socket.send(there, osc_message("/write", "s", {osc_text(path)})); });
    }
    agenda.at(end + 0.6, [&] { socket.send(there, osc_message("/quit", "", {})); });
    agenda.run();
    result.ended = pd.ended(20.0);
    result.notes = read_notes(path);
    std::remove(path.c_str());
    return result;
}

struct Spread {
    double deviation = 0.0, worst = 0.0;
    double mean = 0.0;
};

Spread spread(const std::vector<double>& values) {
    Spread s;
    for (const double v : values) {
        s.mean += v / static_cast<double>(values.size());
    }
    for (const double v : values) {
        s.deviation += (v - s.mean) * (v - s.mean) / static_cast<double>(values.size());
        s.worst = std::max(s.worst, std::abs(v - s.mean));
    }
    s.deviation = std::sqrt(s.deviation);
    return s;
}

/// Lost, doubled, out of order.
struct Faults {
    std::size_t lost = 0, doubled = 0, disordered = 0;
    bool none() const { return lost + doubled + disordered == 0; }
};

Faults faults(const Result& result) {
    Faults f;
    std::vector<int> times(result.instants.size(), 0);
    for (std::size_t i = 0; i < result.notes.size(); ++i) {
        const auto number = static_cast<std::size_t>(result.notes[i].number);
        f.doubled += number >= times.size() || times[number]++ > 0;
        f.disordered += i > 0 && result.notes[i].number < result.notes[i - 1].number;
    }
    f.lost = static_cast<std::size_t>(std::count(times.begin(), times.end(), 0));
    return f;
}

/// How late each contact that fell after some instant was let out: by logical time, less its
/// instant by the monotonic clock [s].
std::vector<double> errors_after(const Result& result, double instant) {
    std::vector<double> errors;
    for (const Note& note : result.notes) {
        const double its = result.instants[static_cast<std::size_t>(note.number)];
        if (its > instant) {
            errors.push_back(note.logical - its);
        }
    }
    return errors;
}

/// From when on, after Pd was let go on, all is within 3 samples of where it stays [s]. A Pd that
/// stood still has lost that time for good.
double time_to_lock(const Result& result) {
    const double settled = spread(errors_after(result, result.continued + 3.0)).mean;
    double last = 0.0;
    for (const Note& note : result.notes) {
        const double instant = result.instants[static_cast<std::size_t>(note.number)];
        if (std::abs(note.logical - instant - settled) * kRate > 3.0) {
            last = std::max(last, instant - result.continued);
        }
    }
    return last;
}

bool report(const Scenario& scenario, char** arguments) {
    const Result result = play(scenario, arguments);
    const Faults f = faults(result);
    std::printf("| %s | %zu | %zu | %zu | %zu |", scenario.name.c_str(), result.instants.size(),
                f.lost, f.doubled, f.disordered);
    const double begin = result.instants.front();
    const double from = scenario.stop_at > 0.0 ? result.continued + 1.0 : begin + kSettling;
    if (scenario.burst == 0) {
        const Spread s = spread(errors_after(result, from));
        std::printf(" %.2f | %.1f |", s.deviation * kRate, s.worst * kRate);
    }
    if (scenario.stop_at > 0.0) {
        std::printf(" locked again within %.2f s", time_to_lock(result));
    }
    std::printf("\n");
    std::fflush(stdout);
    return f.none() && result.ended;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 4) {
        std::cerr << "osc_receive_report PD EXTERNALS PATCHES [--laws]\n";
        return 2;
    }
    prctl(PR_SET_TIMERSLACK, 1);
    const bool laws = count > 4 && std::string(arguments[4]) == "--laws";
    const double length = laws ? 3.0 : 20.0;
    const RelaySettings bad{.delay = 1e-3, .jitter = 5e-3, .loss = 0.2, .doubled = 0.1};
    std::vector<Scenario> scenarios{
        {.name = "20 % lost, 10 % doubled, 5 ms jitter, 50 ppm",
         .seconds = length,
         .network = bad,
         .drift = 50e-6},
        {.name = "a burst of 3000", .burst = 3000},
    };
    if (!laws) {
        scenarios.push_back({.name = "loopback", .seconds = length});
        scenarios.push_back({.name = "loopback, 50 ppm", .seconds = length, .drift = 50e-6});
        scenarios.push_back({.name = "1 ms + 1 ms jitter, 50 ppm",
                             .seconds = length,
                             .network = {.delay = 1e-3, .jitter = 1e-3},
                             .drift = 50e-6});
        scenarios.push_back({.name = "10 ms jitter, 50 ppm",
                             .seconds = 60.0,
                             .network = {.delay = 1e-3, .jitter = 1e-2},
                             .drift = 50e-6});
        scenarios.push_back({.name = "10 ms jitter, 50 ppm, /clock 100 times a second",
                             .seconds = 60.0,
                             .network = {.delay = 1e-3, .jitter = 1e-2},
                             .drift = 50e-6,
                             .clocks = 100.0});
        scenarios.push_back(
            {.name = "loopback, Pd stopped for 0.5 s", .seconds = length, .stop_at = 10.0});
    }
    std::puts(
        "| network | contacts | lost | doubled | out of order | deviation, samples | worst |");
    std::puts("|---|---|---|---|---|---|---|");
    bool good = true;
    for (const Scenario& scenario : scenarios) {
        good = report(scenario, arguments) && good;
    }
    return good ? 0 : 1;
}
