// One stroke's sound, made of two things: partials that ring, and noise that hisses.
#pragma once

#include <vector>

#include "core/listening/practice/dice.hpp"

namespace percussionist::listening::practice {

/// A partial that decays, its pitch falling from `bend` times the final one.
struct Ring {
    double frequency = 100.0;  ///< [Hz]
    double amplitude = 1.0;
    double t60 = 0.3;      ///< [s]
    double bend = 1.0;     ///< of the frequency at the start
    double settle = 0.02;  ///< in which the bend falls to a 1/e [s]
};

/// Noise between two frequencies that rises, stays and decays.
struct Hiss {
    double low = 200.0;    ///< [Hz]
    double high = 8000.0;  ///< [Hz]
    double amplitude = 1.0;
    double rise = 0.001;  ///< [s]
    double hold = 0.0;    ///< [s]
    double t60 = 0.2;     ///< [s]
    double delay = 0.0;   ///< [s]
};

struct Recipe {
    std::vector<Ring> rings;
    std::vector<Hiss> hisses;
    double softest = 0.3;  ///< by how much less bright the softest stroke is
};

/// The sound of one stroke, ending where it is 60 dB down; `brightness` of 1 is the hardest.
/// Small chance variations make no two strokes the same.
std::vector<double> sound_of(const Recipe& recipe, double brightness, double rate, Dice& dice);

}  // namespace percussionist::listening::practice
