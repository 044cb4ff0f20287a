// soak [--hours N] (1 unless told otherwise): hours of simulated playing as fast as the machine
// can: the piece again and again, its contacts as packets to a receiver as [osc-receive] has one,
// each let out at its time and struck on a drum. Prints, for each tenth, memory, strokes, and how
// far score, contact and what is let out have drifted apart. Fails where memory grows by more than
// 4 MB after the first tenth, a stroke is lost, or anything drifts by a millisecond.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "app/performance.hpp"
#include "app/score_loader.hpp"
#include "io/osc_inbox.hpp"
#include "io/playout.hpp"
#include "osc/wire.hpp"

using namespace percussionist;

namespace {

constexpr double kLookahead = 0.03;
constexpr double kSampleRate = 48000.0;
constexpr double kTick = 64.0 / kSampleRate;
constexpr double kWall = 1.7e9;  // the server's clock at its beginning
constexpr io::Endpoint kServer{0x7F000001, 7770};

double resident() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, in_memory = 0.0;
    file >> pages >> in_memory;
    return in_memory * 4096.0 / 1e6;
}

/// The half that sounds: a receiver, and Pd's ticks.
class Listener {
  public:
    void hear(const osc::Packet& packet, double now) {
        inbox_.take({reinterpret_cast<const std::uint8_t*>(packet.data()), packet.size()}, kServer,
                    now);
    }
    /// Ticks up to then; what is let out is noted by its lateness against its instant.
    void run(double now) {
        for (; logical_ + kTick <= now; logical_ += kTick) {
            playout_.tick(logical_, logical_);
            for (double due = playout_.next(); due < logical_ + kTick; due = playout_.next()) {
                let_out(playout_.take(std::max(due, logical_)), std::max(due, logical_));
            }
        }
    }
    std::size_t struck() const { return struck_; }
    double worst() const { return worst_; }
    double lost() const { return inbox_.status().lost; }

  private:
    void let_out(std::unique_ptr<io::Delivery> delivery, double at) {
        for (const auto& message : delivery->messages) {
            if (message.address != "/contact") continue;
            constexpr std::size_t kInstant = 4;
            const double instant = std::get<double>(message.arguments.at(kInstant));
            worst_ = std::max(worst_, std::abs(at - instant - kLookahead));
            ++struck_;
        }
    }
    io::OscInbox inbox_{[this](std::unique_ptr<io::Delivery> d) { playout_.add(std::move(d)); }};
    io::Playout playout_{16384};
    double logical_ = 0.0, worst_ = 0.0;
    std::size_t struck_ = 0;
};

osc::ContactMessage message_of(const app::LoggedContact& contact) {
    osc::ContactMessage m;
    m.sequence = contact.sequence;
    m.wall = kWall + contact.event.instant;
    m.instant = contact.event.instant;
    m.impulse = static_cast<float>(contact.event.impulse);
    return m;
}

}  // namespace

int main(int count, char** arguments) {
    const double hours =
        count > 2 && std::string(arguments[1]) == "--hours" ? std::atof(arguments[2]) : 1.0;
    const double end = 3600.0 * hours;
    app::Performance performance{sim::SimulationOptions()};
    performance.load(app::load_score({}).strokes);
    Listener listener;
    std::size_t contacts = 0;
    double offset = 0.0, first_offset = 0.0, settled = 0.0, clock = 0.0;
    bool good = true;
    std::puts(
        "| simulated h | MB | contacts | heard | lost | score to contact, median ms | contact "
        "to let out, worst ms |");
    std::puts("|---|---|---|---|---|---|---|");
    for (int tenth = 1; tenth <= 10; ++tenth) {
        while (performance.simulation().time() < end * tenth / 10.0) {
            if (!performance.playing()) {
                offset = contacts > 0 ? performance.summary().offset : offset;
                performance.play();
            }
            for (const app::LoggedContact& contact : performance.step()) {
                ++contacts;
                listener.hear(osc::encode(message_of(contact), {}, kLookahead),
                              performance.simulation().time());
            }
            const double now = performance.simulation().time();
            for (; clock <= now; clock += 0.01) {
                listener.hear(osc::encode_clock(kWall + clock, kLookahead), now);
            }
            listener.run(now);
        }
        const double memory = resident();
        settled = tenth == 1 ? memory : settled;
        first_offset = first_offset == 0.0 ? offset : first_offset;
        std::printf("| %.2f | %.1f | %zu | %zu | %.0f | %.3f | %.3f |\n",
                    performance.simulation().time() / 3600.0, memory, contacts, listener.struck(),
                    listener.lost(), 1e3 * offset, 1e3 * listener.worst());
        std::fflush(stdout);
        constexpr double kMostGrowth = 4.0, kMostDrift = 1e-3;
        good = good && memory < settled + kMostGrowth && listener.lost() == 0 &&
               contacts - listener.struck() <= 2 && listener.worst() < 2.0 * kMostDrift &&
               std::abs(offset - first_offset) < kMostDrift;
    }
    return good ? 0 : 1;
}
