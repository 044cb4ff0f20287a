// A simulated FASTRAK at work: unit, line and faults behind a pseudo-terminal, in real time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracker/fastrak_unit.hpp"
#include "tracker/line_faults.hpp"
#include "tracker/pseudo_terminal.hpp"

namespace percussionist::tracker {

/// From one instant on, for some time [s].
struct Span {
    double at = 0.0;
    double duration = 0.0;
};

struct SimulatedDeviceSettings {
    FastrakUnitSettings unit;
    LineFaultSettings faults;
    bool strict_baud = false;  ///< another rate than the unit's own sees garbage, as on a real line
    std::string link;          ///< a name for the port that stays
    std::optional<Span> silence, unplug;
};

class SimulatedDevice {
  public:
    /// Throws std::runtime_error. `tell` gets the port's name, now and after each unplugging.
    SimulatedDevice(const SimulatedDeviceSettings& settings, Motion motion,
                    std::function<void(const std::string&)> tell);

    /// What is due by then [s since the start].
    void run(double now);
    /// "garbage 5", "cut 2" [%], "silence 1.5", "unplug 3" [s], "baud 38400", "error j". Throws
    /// std::runtime_error that says what is understood.
    void order(const std::string& line, double now);
    /// To wait for what comes; -1 while unplugged.
    int descriptor() const { return port_ ? port_->descriptor() : -1; }

  private:
    void plug();
    bool rates_agree() const;
    void restart_unit(int baud);

    SimulatedDeviceSettings settings_;
    Motion motion_;
    std::function<void(const std::string&)> tell_;
    LineFaults faults_;
    std::unique_ptr<FastrakUnit> unit_;
    std::unique_ptr<PseudoTerminal> port_;
    std::mt19937 noise_{1};
};

}  // namespace percussionist::tracker
