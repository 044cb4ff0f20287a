// A drum kit that nobody has heard before: each of its pieces a recipe thrown by dice within what
// such drums are made of.
//
// Ranges are wide on purpose: who has listened to all of them knows what a kick is, and not one
// kick.
#pragma once

#include <array>
#include <vector>

#include "core/listening/drum_class.hpp"
#include "core/listening/practice/sound.hpp"

namespace percussionist::listening::practice {

enum class Piece {
    kick,
    snare,
    side_stick,
    closed_hat,
    pedal_hat,
    open_hat,
    ride,
    bell,
    crash,
    second_crash,
    high_tom,
    middle_tom,
    low_tom,
    hand_percussion,
    shaken_percussion,
};
constexpr std::size_t kPieces = 15;

DrumClass class_of(Piece piece);

class Kit {
  public:
    Kit(double rate, Dice& dice);

    /// The sound of a stroke of velocity 0 to 1, its level in the mix included.
    [[nodiscard]] std::vector<double> stroke(Piece piece, double velocity, Dice& dice) const;

  private:
    struct Part {
        Recipe recipe;
        double level = 1.0;
    };
    double rate_;
    std::array<Part, kPieces> parts_;
};

}  // namespace percussionist::listening::practice
