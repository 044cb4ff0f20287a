// What a studio does to sound: a room, an equaliser, a compressor, tape.
#pragma once

#include <vector>

#include "core/listening/practice/dice.hpp"

namespace percussionist::listening::practice {

/// Reverberation added: eight delays that feed each other, thrown by dice.
void add_room(std::vector<double>& signal, double rate, Dice& dice);
/// Bells here and there.
void equalise(std::vector<double>& signal, double rate, double most_db, Dice& dice);
/// Nothing left above some high frequency, as codecs do.
void cut_top(std::vector<double>& signal, double rate, Dice& dice);
/// Loud things made softer, then saturated.
void compress(std::vector<double>& signal, double rate, Dice& dice);
/// To a root mean square of 1.
void normalise(std::vector<double>& signal);

}  // namespace percussionist::listening::practice
