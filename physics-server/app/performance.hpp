// A performance step by step: player and simulation together, and the log of what came of it.
// The server drives it by the wall clock, the renderer as fast as it can.
//
// One thread; deterministic: the same calls give the same contacts, to the last bit.
#pragma once

#include <functional>
#include <vector>

#include "app/performance_log.hpp"
#include "app/player.hpp"
#include "app/score_loader.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

class Performance {
  public:
    explicit Performance(const sim::SimulationOptions& options)
        : simulation_(options), player_(simulation_) {}

    void load(std::vector<score::Stroke> strokes,
              const std::shared_ptr<const CapturedMotion>& motion = nullptr);
    /// From the beginning; what was logged before is forgotten.
    void play();
    void stop();

    /// One step of the simulation; the contacts that ended in it, with the strokes they came of.
    const std::vector<LoggedContact>& step();

    /// True from play() until the last stroke has been played and has rung out.
    [[nodiscard]] bool playing() const { return performing_; }
    [[nodiscard]] TimingSummary summary() const { return log_.summary(player_.asked()); }
    [[nodiscard]] const PerformanceLog& log() const { return log_; }
    /// To be steered between two steps.
    Player& player() { return player_; }
    sim::Simulation& simulation() { return simulation_; }
    [[nodiscard]] const Player& player() const { return player_; }
    [[nodiscard]] const sim::Simulation& simulation() const { return simulation_; }

  private:
    sim::Simulation simulation_;
    Player player_;
    PerformanceLog log_;
    std::vector<sim::ContactEvent> events_;
    std::vector<LoggedContact> contacts_;
    int sequence_ = 0;
    bool performing_ = false;
};

}  // namespace percussionist::app
