// Lets deliveries out at their logical time, whatever that clock does.
//
// Pd runs its ticks in bursts, late, and after a drop-out of the audio device later for good. So
// Pd's logical clock is followed too (ClockTracker, SteadyLine): once a tick it is told the time.
// What waits has its time reckoned anew at each tick.
//
// Room is made at creation: nothing allocates afterwards. Times are arguments: `logical` is Pd's,
// `monotonic` this machine's [s]. All in Pd's one thread.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/timing/clock_tracker.hpp"
#include "core/timing/steady_line.hpp"
#include "io/osc_inbox.hpp"

namespace percussionist::io {

class Playout {
  public:
    explicit Playout(std::size_t room);

    /// At the beginning of each tick.
    void tick(double logical, double monotonic) noexcept {
        clock_.observe(logical, monotonic);
        line_.follow(clock_, logical);
    }

    bool full() const noexcept { return waiting_.size() == room_; }
    /// Only if it is not full.
    void add(std::unique_ptr<Delivery> delivery) noexcept;

    /// When the next is due; at once: minus infinity; none: infinity.
    double next() const noexcept;
    /// The next, if it is due by then; else null. What is stale comes without its messages.
    std::unique_ptr<Delivery> take(double logical) noexcept;

    /// Seconds by which everything with a time tag is let out later.
    void set_latency(double latency) noexcept { latency_ = latency; }

    /// What came after its time, and by how much the latest [s].
    unsigned long late() const noexcept { return late_; }
    double latest() const noexcept { return latest_; }
    double waiting() const noexcept { return static_cast<double>(waiting_.size()); }

  private:
    std::size_t room_;
    std::vector<std::unique_ptr<Delivery>> waiting_;  // a heap
    timing::ClockTracker clock_{{.step = 1e-3}};
    timing::SteadyLine line_{{.least_tolerance = 2e-4, .most_tolerance = 2e-4}};
    double latency_ = 0.0;
    unsigned long late_ = 0;
    double latest_ = 0.0;
};

}  // namespace percussionist::io
