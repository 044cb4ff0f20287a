// Somebody who speaks: syllables of stops, hisses, nasals and vowels, in phrases, with pauses.
//
// A source and a filter (Fant 1960): pulses of the voice, or noise where it whispers, through
// resonances that glide from one vowel's to the next one's; hisses made at the teeth, stops that
// close, burst and breathe. Nobody could understand it, but its attacks are those of speech: some
// as sudden as a stick, hisses as bright as a hat, and none of them in time.
#pragma once

#include <cstddef>
#include <vector>

#include "core/listening/practice/dice.hpp"

namespace percussionist::listening::practice {

/// Mono, of `samples` samples; its level means nothing.
std::vector<double> speech(std::size_t samples, double rate, Dice& dice);

}  // namespace percussionist::listening::practice
