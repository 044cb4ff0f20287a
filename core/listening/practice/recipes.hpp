// What the pieces of a drum kit are made of: recipes thrown by dice within what such drums are.
//
// Skins ring at the ratios of a circular membrane, kicks and toms bend down in pitch, snares add
// wires that hiss, cymbals are dozens of partials in no ratio above a bed of noise.
#pragma once

#include "core/listening/practice/dice.hpp"
#include "core/listening/practice/sound.hpp"

namespace percussionist::listening::practice {

/// The amplitude of so many decibels.
double db(double decibels);

Recipe kick(Dice& dice);
Recipe snare(Dice& dice);
Recipe side_stick(Dice& dice);
Recipe ride(Dice& dice, bool bell);
Recipe crash(Dice& dice);
/// frequency [Hz], t60 [s], `bend` of the pitch at the start, `slope` of the overtones [dB].
Recipe tom(double frequency, double t60, double bend, double slope, double stick_db, Dice& dice);
/// Conga, bongo; cowbell, block.
Recipe by_hand(Dice& dice);
/// Shaker, tambourine.
Recipe shaken(Dice& dice);

/// Hats of one pair, closed, by the foot or open: alike but for how long they ring.
class HatMaker {
  public:
    explicit HatMaker(Dice& dice);
    Recipe operator()(double t60, double rise, Dice& dice) const;

  private:
    double low_, high_, metal_db_, body_db_;
};

}  // namespace percussionist::listening::practice
