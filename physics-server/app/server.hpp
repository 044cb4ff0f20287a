// The running server: the simulation locked to the wall clock (StepClock), commands in, events out.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/errand.hpp"
#include "app/performance.hpp"
#include "app/score_loader.hpp"
#include "app/steering.hpp"
#include "app/step_clock.hpp"
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

    /// Runs until `stop` is set, or the score ends if so asked. The thread that calls it is the
    /// simulating one. Throws std::runtime_error if contacts.csv cannot be written, or a score in
    /// the replay cannot be read.
    void run(const std::atomic<bool>& stop);

    [[nodiscard]] int port() const { return endpoint_.port(); }
    [[nodiscard]] int late_steps() const { return pace_.late_steps(); }
    [[nodiscard]] const Performance& performance() const { return performance_; }

  private:
    void hear(const osc::Heard& heard);
    void obey_or_refuse(const osc::Heard& heard);
    void obey(const osc::Heard& heard);
    void play_again();
    void record(const osc::Heard& heard, const std::string& file);
    void begin_loading(const osc::Heard& heard, const std::string& name);
    void take_errands();
    void use(LoadedScore loaded);
    template <class Message>
    void tell(Message message);
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
    [[nodiscard]] std::int64_t steps() const { return performance_.simulation().steps(); }

    ServeOptions options_;
    Performance performance_;
    StepClock pace_;
    Steering steering_;
    osc::Endpoint endpoint_;
    Tape tape_;
    std::size_t replayed_ = 0;  ///< records of the replay
    Errand<LoadedScore> loading_;
    Errand<std::string> saving_;
    double next_pose_ = 0.0, next_status_ = 0.0;  ///< simulated [s]
    bool ended_ = false;
};

}  // namespace percussionist::app
