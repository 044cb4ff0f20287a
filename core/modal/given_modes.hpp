// Modes given outright: measured from recordings, or computed elsewhere.
//
// A mode has a frequency, a decay and a weight at each of some places between the middle of a head
// and its rim: w = phi / sqrt(modal mass) [1/sqrt(kg)], so that a force F at a place accelerates
// the mode's amplitude by F w, and what moves there is w times the amplitude. Between the places
// the weight is that of the cubic through the four nearest. With m nodal diameters it turns as
// cos(m theta), and a second mode as sin(m theta) sounds beside it; where m is not known, 0, the
// weight is the same all round.
//
// Values and pure functions. mode_file.hpp writes and reads them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/modal/round_modes.hpp"

namespace percussionist::modal {

struct GivenMode {
    double frequency = 0.0;       ///< as it rings [Hz]
    double t60 = 0.0;             ///< [s]
    int diameters = 0;            ///< m
    std::vector<double> weights;  ///< at each place [1/sqrt(kg)]
    double heard = 0.0;           ///< by a microphone, of the amplitude's velocity
};

struct GivenModes {
    std::string name = "modes";
    std::string origin = "computed";     ///< "computed ..." or "measured ...": one line
    double radius = 0.33;                ///< [m]
    std::vector<double> places = {0.0};  ///< r over radius, rising, from 0 to 1
    std::vector<GivenMode> modes;
};

/// Throws std::invalid_argument, naming mode and field, for what cannot be; more than kMostModes.
void check(const GivenModes& given);

/// How many modes sound: those with diameters are pairs.
std::size_t sounding_modes(const GivenModes& given);

/// Every sounding mode's weight at a spot, pairs beside each other, cosine first. (The spread is
/// not known to modes without a wave number: it is left aside.) `values` has room.
void evaluate_weights(const GivenModes& given, const Spot& spot, std::span<double> values) noexcept;

/// What a microphone hears of each sounding mode.
void heard_weights(const GivenModes& given, std::span<double> values) noexcept;

}  // namespace percussionist::modal
