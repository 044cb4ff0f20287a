// stage_report SERVER PD EXTERNALS PATCHES [--laws] [NAME...]: the server on one host, Pd on
// another, a bad network between them, in real time; prints how many strokes were lost or doubled
// and how evenly they lie in the recorded sound. Of the scenarios, those named; all without. Fails
// where a stroke is lost that could be saved, or doubled, or all is not in step again within 2 s;
// with --laws all is shorter. Ends with 77 where the kernel gives no networks.
#include <signal.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "io/monotonic.hpp"
#include "io/udp_socket.hpp"
#include "net/hosts.hpp"
#include "net/process.hpp"
#include "net/relay.hpp"
#include "support/osc_writer.hpp"

using namespace percussionist;
using namespace percussionist::test;

namespace {

namespace fs = std::filesystem;

constexpr double kRate = 48000.0;
constexpr double kLookahead = 0.15;
constexpr double kSettling = 9.0;  // before the first stroke, while clocks are learnt [s]
constexpr double kShortly = 6.0;   // the same, where evenness does not matter [s]
constexpr double kRaise = 1.0;     // sticks are raised from /play to the first stroke [s]
constexpr double kApart = 0.125;   // strokes [s]
constexpr int kSkipped = 77;

constexpr std::uint32_t kServer = 0x0A4D0102, kPd = 0x0A4D0202;
constexpr std::uint16_t kServerPort = 7770, kPdPort = 7771;

/// What befalls whom, and when after the first stroke [s].
enum class Mishap {
    none,
    cable_out,
    new_address,
    pd_stopped,
    server_stopped,
    pd_killed,
    server_killed
};

struct Scenario {
    std::string name, told;
    RelaySettings network = {};
    int strokes = 64;
    Mishap mishap = Mishap::none;
    double at = 3.0, lasts = 0.0;
};

struct Note {
    double logical = 0.0;
    int number = 0;
};

struct Result {
    std::map<int, double> instants;  // by sequence number, simulated [s]
    std::vector<Note> notes;
    std::vector<double> onsets;  // in the sound, samples
    double mended = 0.0;         // since /play [s]
    bool ended = false;
};

void sleep_until(double time) {
    const timespec until{static_cast<time_t>(time),
                         std::lround(1e9 * (time - std::floor(time))) % 1000000000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

/// Strokes kApart apart, louder and softer.
void write_score(const fs::path& path, int strokes) {
    std::ofstream out(path);
    out << "<score-partwise><part-list><score-part id=\"P\"/></part-list><part id=\"P\"><measure>"
           "<attributes><divisions>4</divisions></attributes><sound tempo=\"120\"/>";
    for (int i = 0; i < strokes; ++i) {
        out << "<note dynamics=\"" << 60 + 10 * (i % 5)
            << "\"><unpitched/><duration>1</duration></note>";
    }
    out << "</measure></part></score-partwise>";
}

std::map<int, double> read_instants(const fs::path& path) {
    std::map<int, double> all;
    std::ifstream in(path);
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
        std::stringstream fields(line);
        std::vector<std::string> row;
        for (std::string field; std::getline(fields, field, ',');) {
            row.push_back(field);
        }
        constexpr std::size_t kInstant = 6;
        if (row.size() > kInstant) {
            all[std::stoi(row[0])] = std::stod(row[kInstant]);
        }
    }
    return all;
}

std::vector<Note> read_notes(const fs::path& path) {
    std::ifstream file(path);
    std::vector<Note> notes;
    for (Note note; file >> note.logical >> note.number;) {
        notes.push_back(note);
    }
    return notes;
}

/// Where a WAV of one channel of floats steps up.
std::vector<double> read_onsets(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    const std::size_t data = bytes.find("data");
    std::vector<double> onsets;
    float last = 0.0F;
    for (std::size_t at = data + 8; data != std::string::npos && at + 4 <= bytes.size(); at += 4) {
        float value = 0.0F;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        if (value > 0.5F && last <= 0.5F) {
            onsets.push_back(static_cast<double>((at - data - 8) / 4));
        }
        last = value;
    }
    return onsets;
}

/// The two hosts and what runs on them.
class Stage {
  public:
    Stage(char** arguments, const Hosts& hosts, const Scenario& scenario)
        : arguments_(arguments),
          hosts_(hosts),
          folder_("/tmp/percussionist-stage." + std::to_string(getpid())),
          down_(kPdPort, {kPd, kPdPort}, scenario.network, "0.0.0.0"),
          up_(kServerPort, {kServer, kServerPort}, scenario.network, "0.0.0.0") {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        write_score(folder_ / "score.musicxml", scenario.strokes);
        start_server();
        start_pd();
    }
    ~Stage() { fs::remove_all(folder_); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void start_server() {
        server_.reset();
        server_.emplace(std::vector<std::string>{arguments_[1], "serve", folder_ / "score.musicxml",
                                                 "--listen", "10.77.1.2", "--lookahead", "0.15",
                                                 "--quit-at-end", "--log", folder_},
                        hosts_.server_network());
    }
    void start_pd() {
        pd_.reset();
        const std::string externals = arguments_[3];
        pd_.emplace(
            pd_command(arguments_[2],
                       {"-path", externals, "-path", externals + "/../net", "-open",
                        std::string(arguments_[4]) + "/stage.pd", "-send",
                        "osc-port port " + std::to_string(kPdPort), "-send",
                        "osc-port subscribe 10.77.2.1 " + std::to_string(kServerPort), "-send",
                        "stage-file open -bytes 4 " + (folder_ / "sound.wav").string(), "-send",
                        "stage-file start", "-send", "pd dsp 1"}),
            hosts_.pd_network());
    }
    void play() { socket_.send({kServer, kServerPort}, osc_message("/play", "", {})); }
    void cut(bool out) {
        down_.cut(out);
        up_.cut(out);
    }
    Process& server() { return *server_; }
    Process& pd() { return *pd_; }

    void finish(Result& result) {
        const io::Endpoint pd{kPd, kPdPort};
        socket_.send(pd, osc_message("/write", "s", {osc_text(folder_ / "notes")}));
        sleep_until(io::monotonic_seconds() + 0.3);
        socket_.send(pd, osc_message("/quit", "", {}));
        result.ended = result.ended && pd_->ended(20.0);
        result.instants = read_instants(folder_ / "contacts.csv");
        result.notes = read_notes(folder_ / "notes");
        result.onsets = read_onsets(folder_ / "sound.wav");
    }

  private:
    char** arguments_;
    const Hosts& hosts_;
    fs::path folder_;
    Relay down_, up_;
    io::UdpSocket socket_{"0.0.0.0", 0};
    std::optional<Process> server_, pd_;
};

void befall(Mishap mishap, Stage& stage) {
    switch (mishap) {
        case Mishap::none:
            break;
        case Mishap::cable_out:
            stage.cut(true);
            break;
        case Mishap::new_address:
            Hosts::readdress(3);
            break;
        case Mishap::pd_stopped:
            stage.pd().signal(SIGSTOP);
            break;
        case Mishap::server_stopped:
            stage.server().signal(SIGSTOP);
            break;
        case Mishap::pd_killed:
            stage.pd().signal(SIGKILL);
            break;
        case Mishap::server_killed:
            stage.server().signal(SIGKILL);
            break;
    }
}

void mend(Mishap mishap, Stage& stage) {
    switch (mishap) {
        case Mishap::none:
        case Mishap::new_address:
            break;
        case Mishap::cable_out:
            stage.cut(false);
            break;
        case Mishap::pd_stopped:
            stage.pd().signal(SIGCONT);
            break;
        case Mishap::server_stopped:
            stage.server().signal(SIGCONT);
            break;
        case Mishap::pd_killed:
            stage.start_pd();
            break;
        case Mishap::server_killed:
            stage.start_server();
            sleep_until(io::monotonic_seconds() + 2.0);
            stage.play();
            break;
    }
}

Result perform(const Scenario& scenario, char** arguments, const Hosts& hosts, double settling) {
    Stage stage(arguments, hosts, scenario);
    sleep_until(io::monotonic_seconds() + settling);
    stage.play();
    const double begin = io::monotonic_seconds();
    Result result;
    if (scenario.mishap != Mishap::none) {
        sleep_until(begin + kRaise + scenario.at);
        befall(scenario.mishap, stage);
        sleep_until(begin + kRaise + scenario.at + scenario.lasts);
        mend(scenario.mishap, stage);
        result.mended = io::monotonic_seconds() - begin;
    }
    result.ended = stage.server().ended(scenario.strokes * kApart + 30.0);
    stage.finish(result);
    if (scenario.mishap == Mishap::new_address) {
        Hosts::readdress(1);
    }
    return result;
}

/// Each note of a stroke: its onset in the sound less its instant, in samples. Onsets and notes
/// come in one order.
std::vector<std::pair<int, double>> placements(const Result& result) {
    std::vector<std::pair<int, double>> all;
    const std::size_t count = std::min(result.onsets.size(), result.notes.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto known = result.instants.find(result.notes[i].number);
        if (known != result.instants.end()) {
            all.emplace_back(known->first, result.onsets[i] - kRate * known->second);
        }
    }
    return all;
}

struct Outcome {
    std::size_t strokes = 0, lost = 0, doubled = 0;
    std::size_t uneven = 0;  // more than a sample from the median
    double range = 0.0;      // of the placements [samples]; within 1 is as even as samples are
    double in_step = 0.0;
};

/// What was heard of the run that is judged: a server started anew counts from 0 again.
std::vector<Note> of_last_run(std::vector<Note> notes, std::vector<double>& onsets) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < notes.size(); ++i) {
        first = notes[i].number < notes[i - 1].number ? i : first;
    }
    notes.erase(notes.begin(), notes.begin() + static_cast<std::ptrdiff_t>(first));
    onsets.erase(onsets.begin(),
                 onsets.begin() + static_cast<std::ptrdiff_t>(std::min(first, onsets.size())));
    return notes;
}

/// When what was to be heard could not be, and the two seconds after; simulated [s].
std::pair<double, double> excused(const Scenario& scenario, const Result& result) {
    constexpr double kBackWithin = 2.0;
    const double first = result.instants.empty() ? 0.0 : result.instants.begin()->second;
    switch (scenario.mishap) {
        case Mishap::none:
        case Mishap::server_killed:
            return {0.0, -1.0};
        case Mishap::pd_killed:
            return {0.0, first + result.mended - kRaise + kBackWithin};
        default:
            break;
    }
    return {first + scenario.at - 2.0 * kLookahead, first + result.mended - kRaise + kBackWithin};
}

Outcome judge(const Scenario& scenario, Result result) {
    if (scenario.mishap == Mishap::server_killed) {
        result.notes = of_last_run(std::move(result.notes), result.onsets);
    }
    Outcome outcome;
    std::map<int, int> heard;
    for (const Note& note : result.notes) {
        ++heard[note.number];
    }
    const auto [from, to] = excused(scenario, result);
    for (const auto& [number, instant] : result.instants) {
        const bool counts = instant < from || instant > to;
        outcome.strokes += counts ? 1 : 0;
        outcome.lost += counts && heard[number] == 0 ? 1 : 0;
        outcome.doubled += heard[number] > 1 ? 1 : 0;
    }
    const auto placed = placements(result);
    const double last = placed.empty() ? 0.0 : placed.back().second;
    constexpr double kNear = 3.0;  // samples
    std::vector<double> places;
    outcome.in_step = 1e300;
    for (const auto& [number, place] : placed) {
        const double instant = result.instants.at(number);
        if (instant > to) {
            places.push_back(place);
        }
        const double since = instant - (to - 2.0);
        if (since > 0.0 && std::abs(place - last) < kNear) {
            outcome.in_step = std::min(outcome.in_step, since);
        }
    }
    std::sort(places.begin(), places.end());
    if (!places.empty()) {
        const double median = places[places.size() / 2];
        outcome.range = places.back() - places.front();
        outcome.uneven = static_cast<std::size_t>(
            std::count_if(places.begin(), places.end(),
                          [median](double place) { return std::abs(place - median) > 1.0; }));
    }
    return outcome;
}

bool report(const Scenario& scenario, char** arguments, const Hosts& hosts, double settling) {
    const Result result = perform(scenario, arguments, hosts, settling);
    const Outcome o = judge(scenario, result);
    std::printf("| %s | %s | %zu | %zu | %zu | %zu | %.2f |", scenario.name.c_str(),
                scenario.told.c_str(), o.strokes, o.lost, o.doubled, o.uneven, o.range);
    if (scenario.mishap != Mishap::none) {
        std::printf(" %.2f s |", o.in_step);
    } else {
        std::printf(" |");
    }
    std::printf("%s\n", result.ended ? "" : " did not end well");
    std::fflush(stdout);
    constexpr double kBackWithin = 2.0;
    const bool back = scenario.mishap == Mishap::none || scenario.mishap == Mishap::server_killed ||
                      o.in_step <= kBackWithin;
    return result.ended && o.strokes > 0 && o.lost + o.doubled == 0 && back;
}

std::vector<Scenario> scenarios() {
    const RelaySettings bad{.delay = 1e-3, .jitter = 50e-3, .loss = 0.3, .doubled = 0.05};
    std::vector<Scenario> all{
        {.name = "cable", .told = "no delay, nothing lost"},
        {.name = "bad", .told = "50 ms jitter, 30 % lost, 5 % doubled, reordered", .network = bad},
        {.name = "cable-out",
         .told = "out for 10 s",
         .strokes = 160,
         .mishap = Mishap::cable_out,
         .lasts = 10.0},
        {.name = "address",
         .told = "Pd's host gets another address",
         .strokes = 80,
         .mishap = Mishap::new_address},
        {.name = "pd-stopped",
         .told = "Pd gets no processor for 1 s",
         .strokes = 80,
         .mishap = Mishap::pd_stopped,
         .lasts = 1.0},
        {.name = "server-stopped",
         .told = "the server gets no processor for 1 s",
         .strokes = 80,
         .mishap = Mishap::server_stopped,
         .lasts = 1.0},
        {.name = "pd-killed",
         .told = "Pd is killed and started again",
         .strokes = 80,
         .mishap = Mishap::pd_killed,
         .lasts = 0.5},
        {.name = "server-killed",
         .told = "the server is killed and started again",
         .mishap = Mishap::server_killed,
         .lasts = 0.5},
    };
    for (const int loss : {0, 10, 20, 40, 50, 60}) {
        RelaySettings worse = bad;
        worse.loss = 0.01 * loss;
        all.push_back({.name = "loss-" + std::to_string(loss),
                       .told = "50 ms jitter, 5 % doubled, " + std::to_string(loss) + " % lost",
                       .network = worse});
    }
    for (const int jitter : {10, 80, 100, 140}) {
        RelaySettings worse = bad;
        worse.jitter = 1e-3 * jitter;
        all.push_back({.name = "jitter-" + std::to_string(jitter),
                       .told = "30 % lost, 5 % doubled, " + std::to_string(jitter) + " ms jitter",
                       .network = worse});
    }
    return all;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 5) {
        std::cerr << "stage_report SERVER PD EXTERNALS PATCHES [NAME...]\n";
        return 2;
    }
    std::unique_ptr<Hosts> hosts;
    try {
        hosts = std::make_unique<Hosts>();
    } catch (const std::exception& e) {
        std::cerr << "skipped, for want of hosts of its own: " << e.what() << '\n';
        return kSkipped;
    }
    prctl(PR_SET_TIMERSLACK, 1);
    const bool laws = count > 5 && std::string(arguments[5]) == "--laws";
    const std::vector<std::string> names(arguments + (laws ? 6 : 5), arguments + count);
    std::puts(
        "| scenario | what | strokes | lost | doubled | uneven | onsets within, samples | in step "
        "|");
    std::puts("|---|---|---|---|---|---|---|---|");
    bool good = true;
    for (Scenario scenario : scenarios()) {
        if (laws) {
            scenario.lasts = std::min(scenario.lasts, 3.0);
            scenario.strokes = std::min(scenario.strokes, 72);
        }
        if (names.empty() || std::find(names.begin(), names.end(), scenario.name) != names.end()) {
            good = report(scenario, arguments, *hosts, laws ? kShortly : kSettling) && good;
        }
    }
    return good ? 0 : 1;
}
