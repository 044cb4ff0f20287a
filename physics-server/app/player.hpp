// Plays a list of strokes on the simulated percussionist: tells each hand its next stroke when the
// one before has struck, follows changes of tempo, and finds for each contact the stroke it came
// of.
//
// Simulating thread. Score time is seconds at the score's own tempo; simulated time s is reached at
// score time (s - origin) x tempo.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include "core/score/stroke_plan.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

/// What became of a stroke that was asked for.
struct Asked {
    std::size_t stroke = 0;  ///< index in the list
    double time = 0.0;       ///< for which the impact was asked, simulated [s]
};

class Player {
  public:
    explicit Player(sim::Simulation& simulation) : simulation_(simulation) {}

    /// Takes a new list (in order of time); stops what is playing.
    void load(std::vector<score::Stroke> strokes);
    /// From the beginning, the first stroke `lead` seconds from now or later.
    void play();
    void stop();
    /// At once; strokes under way bend to it unless they are about to strike.
    void set_tempo(double factor);
    [[nodiscard]] double tempo() const { return tempo_; }

    /// To be called before each step of the simulation.
    void advance();

    /// When the score's time 0 is, simulated [s].
    [[nodiscard]] double origin() const { return origin_; }
    [[nodiscard]] bool playing() const { return playing_; }
    /// When the last stroke strikes, simulated [s]; meaningful once the score has ended.
    [[nodiscard]] double last_impact() const { return last_impact_; }

    /// Strokes given to the hands in the last advance().
    [[nodiscard]] const std::vector<Asked>& given() const { return given_; }

    /// The stroke that a contact came of, or nothing: none was due there.
    [[nodiscard]] const Asked* cause(const sim::ContactEvent& contact) const;

    [[nodiscard]] const std::vector<score::Stroke>& strokes() const { return strokes_; }
    /// Strokes given to the hands since play(), and those for which the time was too short.
    [[nodiscard]] int asked() const { return asked_; }
    [[nodiscard]] int dropped() const { return dropped_; }

  private:
    struct HandState {
        std::vector<std::size_t> strokes;  ///< of this hand, in order
        std::size_t next = 0;              ///< the first not yet given to it
        std::deque<Asked> recent;          ///< the last few given to it
    };
    void advance(body::Hand hand);
    void retime(body::Hand hand);
    [[nodiscard]] double impact_time(std::size_t stroke) const {
        return origin_ + strokes_[stroke].time / tempo_;
    }
    HandState& state(body::Hand hand) { return hands_[static_cast<int>(hand)]; }

    sim::Simulation& simulation_;
    std::vector<score::Stroke> strokes_;
    std::array<HandState, 2> hands_;
    std::vector<Asked> given_;
    double origin_ = 0.0, tempo_ = 1.0, last_impact_ = 0.0;
    bool playing_ = false;
    int asked_ = 0, dropped_ = 0;
};

}  // namespace percussionist::app
