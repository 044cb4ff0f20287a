// Those who play along: what a drum must be told from. Bass, plucked and struck chords, sustained
// ones, distorted ones, voices with their vowels and their hisses.
#pragma once

#include <vector>

#include "core/listening/practice/dice.hpp"
#include "core/listening/practice/groove.hpp"

namespace percussionist::listening::practice {

/// Their sum, mono, of `samples` samples, in time with the groove; its level means nothing.
std::vector<double> accompaniment(const Groove& groove, std::size_t samples, double rate,
                                  Dice& dice);

}  // namespace percussionist::listening::practice
