// A bodhran player's stick, chest, left hand and head, as a tracker's receivers: what the simulated
// FASTRAK plays. Deterministic; built once, then pure.
#pragma once

#include "core/motion/synthetic_stick.hpp"

namespace percussionist::motion {

/// A man or woman with a bodhran: a jig for ever, every stroke known.
///
/// Stations: 1 in the middle of the stick, 2 on the chest (the drum keeps its place there), 3 on
/// the left hand behind the head, which presses in every second bar, 4 on the forehead. In the
/// frame of a transmitter at the chair, x to the front, y to the left. The player leans and turns.
class BodhranPlayer {
  public:
    BodhranPlayer();

    Pose receiver(int station, double time) const;
    Pose world_from_chest(double time) const;
    /// Where the head is, as seen from the chest.
    static Pose chest_from_drum();
    /// All strokes up to then.
    std::vector<SyntheticStroke> strokes(double until) const;
    const SyntheticStick& stick() const { return stick_; }

  private:
    double in_pattern(double time) const;
    std::vector<SyntheticStroke> pattern_;  // of one period
    SyntheticStick stick_;
};

}  // namespace percussionist::motion
