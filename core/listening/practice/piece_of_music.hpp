// A piece to practise listening on: drums, most often with others playing, and what was struck
// when.
#pragma once

#include <cstdint>
#include <vector>

#include "core/listening/drum_class.hpp"

namespace percussionist::listening::practice {

struct HeardStroke {
    double time = 0.0;  ///< [s]
    DrumClass drum = DrumClass::kick;
    double velocity = 0.0;  ///< 0 to 1
};

struct PieceOfMusic {
    double rate = 44100.0;  ///< [Hz]
    std::vector<double> signal;
    std::vector<HeardStroke> strokes;  ///< in order of time
    bool alone = false;                ///< nothing but drums
    double beat = 0.5;                 ///< [s]
    int beats = 4;                     ///< in a bar
};

/// The same seed makes the same piece.
PieceOfMusic piece_of_music(std::uint64_t seed, double duration);

}  // namespace percussionist::listening::practice
