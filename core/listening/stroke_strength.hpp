// How hard a stroke was, and how high a tom sounds, from what it adds to the bands of its drum.
//
// Does not allocate or throw.
#pragma once

#include <cstddef>
#include <span>

#include "core/listening/band_analyser.hpp"
#include "core/listening/drum_class.hpp"

namespace percussionist::listening {

/// Logarithm of the power that an attack at frames[at] adds, in the bands where such a drum is
/// strong, within the 45 ms after [nats].
float added_power(std::span<const BandFrame> frames, std::size_t at, DrumClass drum) noexcept;

/// The middle of the low band that it adds most to [Hz].
double pitch_of(std::span<const BandFrame> frames, std::size_t at) noexcept;

/// A velocity of a stroke whose added power is `power` where a loud one has `loud`: 30 dB span it.
double velocity_of(float power, float loud) noexcept;

}  // namespace percussionist::listening
