// What was asked for and what came of it: the strokes, their contacts, and how far apart they were.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/player.hpp"
#include "core/score/stroke_plan.hpp"
#include "sim/contact_event.hpp"

namespace percussionist::app {

struct LoggedContact {
    sim::ContactEvent event;
    int sequence = 0;
    int stroke = -1;           ///< -1: it came of none
    double asked_time = 0.0;   ///< of that stroke, simulated [s]
    double asked_speed = 0.0;  ///< of that stroke, at the impact [m/s]
};

struct TimingSummary {
    int strokes = 0;      ///< asked for
    int contacts = 0;     ///< made by strokes, the first of each
    int missed = 0;       ///< strokes without a contact
    int uncalled = 0;     ///< contacts beyond the first of a stroke, or of none
    double offset = 0.0;  ///< median of contact - asked [s]
    double median_error = 0.0, worst_error = 0.0;  ///< of |contact - asked - offset| [s]
};

class PerformanceLog {
  public:
    void clear() { contacts_.clear(); }
    void add(const LoggedContact& contact) { contacts_.push_back(contact); }
    [[nodiscard]] const std::vector<LoggedContact>& contacts() const { return contacts_; }

    [[nodiscard]] TimingSummary summary(int asked) const;
    /// A line a contact; the same contacts give the same bytes. Throws std::runtime_error.
    void write_csv(const std::filesystem::path& path) const;

  private:
    std::vector<LoggedContact> contacts_;
};

/// The times asked for [s] of the strokes in a file that write_csv() wrote, in order of time, each
/// once. Throws std::runtime_error naming file and line.
std::vector<double> read_asked_times(const std::filesystem::path& path);

/// The summary in words, a few lines.
std::string describe(const TimingSummary& summary);

}  // namespace percussionist::app
