// What a drummer plays through a piece: a groove thrown by dice, kept up with small changes, fills
// at the ends of phrases. Some pieces are swung, some are chaos on purpose.
#pragma once

#include <vector>

#include "core/listening/practice/dice.hpp"
#include "core/listening/practice/kit.hpp"

namespace percussionist::listening::practice {

struct Stroke {
    double time = 0.0;  ///< [s]
    Piece piece = Piece::kick;
    double velocity = 0.8;  ///< 0 to 1
};

struct Groove {
    double beat = 0.5;            ///< length [s]
    int beats = 4;                ///< in a bar
    std::vector<Stroke> strokes;  ///< in order of time
};

Groove throw_groove(double duration, Dice& dice);

}  // namespace percussionist::listening::practice
