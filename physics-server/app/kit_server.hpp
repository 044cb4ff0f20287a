// The running server with a drummer at a whole kit: like Server, locked to the wall clock, but
// what plays is a LiveKit, key frames or a body that they lead, and where the song is may be told
// by who plays it.
//
// Each step ends at its time by the clock; contacts, poses and what the kit does are told as of
// then, to be heard the lookahead later. A song that plays elsewhere is therefore led by that much:
// what it is told to be at T is here at T less the lookahead.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/errand.hpp"
#include "app/kit_score.hpp"
#include "app/performance_log.hpp"
#include "app/step_clock.hpp"
#include "body/live_drummer.hpp"
#include "osc/endpoint.hpp"
#include "sim/simulated_drummer.hpp"

namespace percussionist::app {

struct KitServeOptions {
    osc::EndpointOptions endpoint;
    std::filesystem::path kit;           ///< empty: the standard kit
    bool simulated = false;              ///< his body plays, led by key frames; else these alone
    std::filesystem::path score;         ///< empty: the built-in one
    std::filesystem::path score_folder;  ///< where /score may read, /kit/save and /route/save write
    bool play = false;                   ///< at once, without waiting for /play
    bool quit_at_end = false;            ///< when the score has been played and has rung out
    std::filesystem::path log_folder;    ///< contacts.csv goes there; empty: nowhere
};

class KitServer {
  public:
    /// Throws std::runtime_error (port, files) or std::invalid_argument (the kit).
    KitServer(const KitServeOptions& options, WallClock& clock);

    /// Runs until `stop` is set, or the score ends if so asked. The thread that calls it is the
    /// simulating one. Throws std::runtime_error if contacts.csv cannot be written.
    void run(const std::atomic<bool>& stop);

    [[nodiscard]] int port() const { return endpoint_.port(); }
    [[nodiscard]] int late_steps() const { return pace_.late_steps(); }
    [[nodiscard]] TimingSummary summary() const { return log_.summary(asked_); }
    [[nodiscard]] const PerformanceLog& log() const { return log_; }
    [[nodiscard]] const body::LiveKit& player() const;
    [[nodiscard]] double position() const { return song_.position(); }

  private:
    void hear(const osc::Heard& heard);
    bool obey(const osc::Heard& heard);
    void play();
    void stop_playing();
    void follow(const osc::SongPosition& told, const osc::Heard& heard);
    void answer_note(const osc::Note& note, const osc::Heard& heard);
    bool edit(const osc::Command& command);
    void begin_loading(const osc::Heard& heard, const std::string& name);
    void save_kit(const osc::Heard& heard, const std::string& file);
    void take_errands();
    [[nodiscard]] body::LiveKit& player();
    void use(KitScore loaded);
    void step();
    void tell_due();
    void tell_contact(const body::KitContact& contact);
    void tell_pose();
    void tell_scene();
    void tell_state();
    void tell_status();
    void check_end();
    template <class Message>
    void tell(Message message);

    KitServeOptions options_;
    std::string kit_text_;
    body::LiveDrummer drummer_;
    std::unique_ptr<sim::SimulatedDrummer> body_;  ///< none: key frames alone
    score::SongClock song_;
    osc::Endpoint endpoint_;
    KitScore score_;
    Errand<KitScore> loading_;
    Errand<std::string> saving_;
    PerformanceLog log_;
    double step_;  ///< [s]
    StepClock pace_;
    std::int64_t steps_ = 0;  ///< done
    double time_ = 0.0;       ///< of the last step [s]
    double next_pose_ = 0.0, next_tick_ = 0.0, next_status_ = 0.0;
    int sequence_ = 0, asked_ = 0;
    bool performing_ = false;  ///< a song that has not ended
    bool changed_ = false, ended_ = false;
};

}  // namespace percussionist::app
