// The tones of those who play along: one period of a wave, read again and again.
#pragma once

#include <vector>

#include "core/listening/practice/dice.hpp"

namespace percussionist::listening::practice {

/// A tone's shape in time.
struct Shape {
    double attack = 0.005;    ///< [s]
    double t60 = 1.0;         ///< [s]
    double release = 0.05;    ///< [s]
    double vibrato = 0.0;     ///< depth, of the frequency
    double glide = 0.0;       ///< from how far below it comes, of the frequency
    double pluck_db = -40.0;  ///< noise at the attack
};

struct Tone {
    double time, duration, frequency, amplitude;  ///< [s], [s], [Hz], full scale being 1
};

/// One period, its partials falling by a slope; without those above `limit` [Hz].
std::vector<double> wave(double frequency, double slope_db, double limit, Dice& dice);

/// Adds a tone, cut where the signal ends.
void add(const Tone& tone, const Shape& shape, const std::vector<double>& table, double rate,
         Dice& dice, std::vector<double>& out);

}  // namespace percussionist::listening::practice
