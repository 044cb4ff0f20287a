// The running server: the simulation locked to the wall clock, commands in, events out.
//
// Step k of the simulation is computed when the clock reaches start + k h, never earlier, so that
// simulated time cannot drift; steps that come late are counted and caught up. If the machine was
// held up for long the start moves on instead: a pause, not a burst of strokes.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/performance.hpp"
#include "app/steering.hpp"
#include "app/tape.hpp"
#include "app/wall_clock.hpp"
#include "files/recording_file.hpp"
#include "osc/endpoint.hpp"

namespace percussionist::app {

struct ServeOptions {
    sim::SimulationOptions simulation;
    osc::EndpointOptions endpoint;
    std::filesystem::path score;         ///< empty: the built-in one
    std::filesystem::path score_folder;  ///< where /score may read, /record and /route/save write
    std::filesystem::path gestures;      ///< of your own, see gesture_library.hpp; empty: none
    bool play = false;                   ///< at once, without waiting for /play
    bool quit_at_end = false;            ///< when the score has been played and has rung out
    std::filesystem::path log_folder;    ///< contacts.csv goes there; empty: nowhere
    std::string settings;                ///< what `simulation` was made from, for a recording
    std::filesystem::path recording;     ///< from the start; empty: none
    /// Played again in place of what is heard; ends with it.
    std::shared_ptr<const files::Recording> replay;
    /// Each thing told, at which step, with simulated time for wall clock; each step done.
    std::function<void(std::int64_t step, const osc::Packet&)> told;
    std::function<void(const Performance&)> stepped;
};

class Server {
  public:
    /// Throws std::runtime_error (port, files) or std::invalid_argument (options).
    Server(const ServeOptions& options, WallClock& clock);

    /// Runs until `stop` is set, or the score ends if so asked.
    void run(const std::atomic<bool>& stop);

    [[nodiscard]] int port() const { return endpoint_.port(); }
    [[nodiscard]] int late_steps() const { return late_steps_; }
    [[nodiscard]] const Performance& performance() const { return performance_; }

  private:
    void hear(const osc::Heard& heard);
    void obey(const osc::Command& command);
    void steer(const osc::Command& command);
    void play_again();
    void record(const osc::Record& wish);
    void begin_loading(const osc::LoadScore& wish);
    void save_routes(const osc::SaveRoutes& wish);
    void take_loaded_score();
    void use(LoadedScore loaded);
    template <class Message>
    void tell(Message message);
    void catch_up(double now);
    [[nodiscard]] double next_step_end() const;  ///< simulated [s]
    void step();
    void tell_contact(const LoggedContact& contact);
    void tell_pose();
    void play();
    void tell_strike(const Asked& given);
    void tell_scene();
    void tell_state();
    void tell_status();
    void tell_finished();
    void write_log() const;
    [[nodiscard]] double wall(double simulated) const { return start_ + simulated; }
    [[nodiscard]] std::int64_t steps() const { return performance_.simulation().steps(); }

    ServeOptions options_;
    WallClock& clock_;
    Performance performance_;
    Steering steering_;
    osc::Endpoint endpoint_;
    Tape tape_;
    std::size_t replayed_ = 0;  ///< records of the replay
    std::future<LoadedScore> loading_;
    std::future<void> saving_;
    double start_ = 0.0;                          ///< wall clock at simulated time 0 [s]
    double next_pose_ = 0.0, next_status_ = 0.0;  ///< simulated [s]
    double busy_ = 0.0;                           ///< computing time since the last status [s]
    int late_steps_ = 0;
    bool ended_ = false;
};

}  // namespace percussionist::app
