// Plays a list of strokes on the simulated percussionist: tells each hand its next stroke when the
// one before has struck, in the manner asked for, and finds for each contact the stroke it came of.
// Or plays a captured motion, whose strokes are what is expected of it: of what can be asked for,
// the tempo alone holds for it.
//
// Simulating thread. Everything may change while it plays: strokes under way bend to it unless they
// are about to strike. Score time is seconds at the score's own tempo; score::TempoCurve says when
// in simulated time it comes.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "body/gesture.hpp"
#include "body/playable_clip.hpp"
#include "core/score/stroke_plan.hpp"
#include "core/score/tempo_curve.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

/// What became of a stroke that was asked for.
struct Asked {
    std::size_t stroke = 0;  ///< index in the list
    double time = 0.0;       ///< for which the impact was asked, simulated [s]
    body::Hand hand = body::Hand::right;
    body::StrokeShape shape;  ///< if there was time for all of it
};

class Player {
  public:
    explicit Player(sim::Simulation& simulation) : simulation_(simulation) {}

    /// Takes a new list (in order of time); stops what is playing. With a clip the strokes are its.
    void load(std::vector<score::Stroke> strokes,
              std::shared_ptr<const body::PlayableClip> clip = nullptr);
    /// From the beginning, the first stroke `lead` seconds from now or later.
    void play();
    void stop();

    /// Reaches the factor within `seconds`: at once, or as an accelerando or ritardando.
    void set_tempo(double factor, double seconds = 0.0);
    /// See score::TempoCurve::sway.
    void set_rubato(double depth, double period);
    [[nodiscard]] const score::TempoCurve& tempo() const { return tempo_; }
    /// Strokes of a hand in this gesture; none: as their nuance in the score has it.
    void set_gesture(body::Hand hand, std::optional<body::Gesture> gesture);
    [[nodiscard]] const std::optional<body::Gesture>& gesture(body::Hand hand) const {
        return hands_[static_cast<int>(hand)].gesture;
    }
    /// Sticks are raised this many times as high.
    void set_height(double factor);
    [[nodiscard]] double height() const { return height_; }
    /// The hand that plays what the score gives the right one. While playing both change over where
    /// neither has to strike again too soon.
    void set_leading(body::Hand hand) { wished_leading_ = hand; }
    [[nodiscard]] body::Hand leading() const { return wished_leading_; }

    /// To be called before each step of the simulation.
    void advance();

    /// When the score's time 0 is, simulated [s].
    [[nodiscard]] double origin() const { return tempo_.time_of(0.0); }
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
        std::optional<body::Gesture> gesture;
    };
    void advance(body::Hand hand);
    [[nodiscard]] bool busy(body::Hand hand) const;
    [[nodiscard]] bool over() const;
    void rebend(body::Hand hand);
    void rebend();
    void share_out();
    void change_over();
    [[nodiscard]] bool can_take_over(const HandState& from, const HandState& to) const;
    void shape(body::Hand hand, Asked& asked) const;
    bool give(body::Hand hand, const Asked& asked);
    [[nodiscard]] double impact_time(std::size_t stroke) const {
        return tempo_.time_of(strokes_[stroke].time);
    }
    HandState& state(body::Hand hand) { return hands_[static_cast<int>(hand)]; }

    sim::Simulation& simulation_;
    std::vector<score::Stroke> strokes_;
    std::shared_ptr<const body::PlayableClip> clip_;
    std::array<HandState, 2> hands_;
    std::vector<Asked> given_;
    score::TempoCurve tempo_;
    double height_ = 1.0, last_impact_ = 0.0;
    body::Hand leading_ = body::Hand::right, wished_leading_ = body::Hand::right;
    bool playing_ = false;
    int asked_ = 0, dropped_ = 0;
};

}  // namespace percussionist::app
