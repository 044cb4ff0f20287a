// Follows one clock, x, by another, y, through observations that may come late but never early:
// the times at which packets of a sender arrive, or at which Pd gets to run a tick.
//
//     y = x + offset + rate x + lateness,   lateness >= 0
//
// The observations lie on and above a line. Its estimate is the line that lies below all of them
// and whose vertical distances to them sum to the least: an edge of their lower convex hull, the
// one across the middle of their span (Zhang, Liu and Xia, "Clock synchronization algorithms for
// network measurements", INFOCOM 2002). With n observations it is right to about the lateness by n,
// where their mean would be right to the lateness by sqrt(n). Only the least late observation of
// each block of time is kept, and no more blocks than the lateness asks for.
//
// While there are few, the slope of the hull is noise: it is weighed against the rate known before
// (first 0 +- 50 ppm), by its standard error of about 14 lateness / (n span). The first
// observations seem less late than they are, as the line goes through the least late of them: their
// lateness is what they lie above the least of all, whatever the line.
//
// A step (one of the clocks was set, the machine slept, an audio device dropped out): what comes
// early beyond `step` is believed at once; what comes late, once for a third of a second everything
// does, beyond `step` and beyond what chance would do. The rate is kept. Of the first observations
// it is not known what chance would do: a tenth of a second is thought possible.
//
// Pure, all of it noexcept and without allocation; one thread at a time. Times in seconds; their
// differences are accurate to a double's 1e-16 of their size.
#pragma once

#include <array>
#include <cstddef>

namespace percussionist::timing {

class ClockTracker {
  public:
    struct Settings {
        double block = 0.2;      ///< [s]
        double step = 2e-3;      ///< the least step told from lateness [s]
        double accuracy = 2e-5;  ///< that more blocks are kept for [s]
        double max_rate = 1e-3;
    };

    ClockTracker() : ClockTracker(Settings()) {}
    explicit ClockTracker(const Settings& settings) : settings_(settings) {}

    void observe(double x, double y) noexcept;
    /// One that may be later than others for reasons of its own: heeded only if it comes early.
    void observe_if_early(double x, double y) noexcept;
    /// Forgets everything but the rate.
    void restart() noexcept;

    bool started() const noexcept { return started_; }
    double to_y(double x) const noexcept { return x + origin_ + deviation(x); }
    double to_x(double y) const noexcept;

    /// How much faster y runs than x: 1e-6 for one microsecond a second.
    double rate() const noexcept { return rate_; }
    /// The standard error of that, as far as it is known.
    double rate_error() const noexcept { return rate_error_; }
    /// About how far off the line may be, by its observations' lateness and their number [s].
    double uncertainty() const noexcept;
    /// Mean lateness of the observations [s].
    double lateness() const noexcept;
    /// Steps found since the beginning.
    unsigned steps() const noexcept { return steps_; }

  private:
    static constexpr std::size_t kLeastBlocks = 32;
    static constexpr std::size_t kMostBlocks = 512;

    /// Where kept: y less x and origin_, over x less x0_, small numbers.
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    struct Block {
        Point least;
        double late = 0.0;  // of the least late
        double sum = 0.0;   // of all
        double began = 0.0;
        unsigned count = 0;
    };

    /// The first observations after a lock: y less x.
    struct Beginning {
        unsigned count = 0;
        double sum = 0.0, least = 0.0;
        void add(double value) noexcept {
            least = count == 0 || value < least ? value : least;
            sum += value;
            ++count;
        }
        double lateness() const noexcept { return sum / count - least; }
    };

    double deviation(double x) const noexcept { return offset_ + rate_ * (x - x0_); }
    void lock(double x, double y) noexcept;
    double latest_usual() const noexcept;
    bool stepped_later(double& x, double& y, double late) noexcept;
    void acquit(double y) noexcept;
    void finish_block() noexcept;
    void keep(const Point& point) noexcept;
    void fit() noexcept;
    void add_to_hull(const Point& point) noexcept;
    double hull_slope() const noexcept;
    double slope_error(double span) const noexcept;
    std::size_t blocks_wanted() const noexcept;

    Settings settings_;
    bool started_ = false;
    double x0_ = 0.0, origin_ = 0.0, offset_ = 0.0, rate_ = 0.0;
    double known_rate_ = 0.0, known_error_ = 50e-6;  // before the points now kept
    double rate_error_ = 50e-6;
    double mean_late_ = 0.0, least_late_ = 0.0;  // of observations; of blocks
    double observations_ = 0.0, blocks_ = 0.0;   // behind these means
    double per_block_ = 1.0;
    unsigned steps_ = 0;
    Beginning beginning_;
    Block block_;
    Block suspect_;  // the latest observations, as long as all are too late; plain x and y
    std::array<Point, kMostBlocks> points_{};
    std::size_t first_ = 0, count_ = 0;
    std::array<Point, kMostBlocks + 1> hull_{};
    std::size_t hull_count_ = 0;
};

}  // namespace percussionist::timing
