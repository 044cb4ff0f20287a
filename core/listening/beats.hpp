// Where the beats of a recording lie, and which of them begin a bar.
//
// How long a beat is: the lag at which the accents repeat best, also twice and four times over,
// lengths near half a second being likelier. Where: the path of beats that meets most accents while
// its steps stay near that length, by dynamic programming (Ellis 2007, "Beat tracking by dynamic
// programming"). Bars, of four beats or three: the phase that puts kicks and crashes on the first
// and snares where a back beat has them.
//
// Pure; allocates.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/listening/transcription.hpp"

namespace percussionist::listening {

struct Beats {
    std::vector<double> times;  ///< [s]; empty where nothing is struck
    int per_bar = 4;
    std::size_t first_downbeat = 0;  ///< index of the first beat that begins a bar

    [[nodiscard]] double seconds_per_beat() const;  ///< mean; 0.5 where there are none
};

Beats find_beats(std::span<const DrumStroke> strokes, double duration);

}  // namespace percussionist::listening
