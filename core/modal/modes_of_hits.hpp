// Modes measured from recordings of a drum that was struck at known places: frequencies, decays,
// and how strongly, with which sign, each is felt at each place.
//
// The recordings are cut where their stroke begins, looked at band by band (sub_band.hpp), the
// decaying sines they share found in each (decaying_sines.hpp), and their amplitudes fitted to each
// recording (partials.hpp), the first milliseconds left out, in which the stick still touches.
// All is done in bands of two widths: narrow ones tell more modes apart, wide ones take less off a
// short recording, as of a bass drum between two strokes. What explains the recordings better is
// taken.
// A mode is kept that stands out of what the fit leaves of a recording, in the bandwidth it fills.
//
// A stroke is taken for an impulse, and all strokes for equally hard. Then the amplitude of mode k
// struck at place p is h_k w_k(p): w_k the mode's weight there, h_k what the microphone hears of
// it. Their phases agree from stroke to stroke but for a half turn, where w_k changes its sign, and
// for what the strokes' beginnings are apart, which is sought first. Where a phase is neither, the
// sign is not known: the weight is then given as positive, and counted.
//
// From recordings nothing can be known of masses. The weights are scaled so that the largest of
// each mode is 1 / sqrt(kTypicalMass), and h_k so that after a stroke of kTypicalImpulse the
// loudest mode begins with kTypicalPressure.
//
// Procedure after Avanzini, Rath and Rocchesso 2002, and the Vodhran's (Marshall, Moynihan, Rath
// 2002), with ESPRIT in the place of peaks in a spectrum. Allocates; takes seconds.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/modal/given_modes.hpp"
#include "core/modal/partials.hpp"

namespace percussionist::modal {

struct Hit {
    double place = 0.0;           ///< r over radius, 0 to 1
    std::vector<double> samples;  ///< one channel, one stroke
};

struct HitAnalysis {
    double low = 30.0;      ///< modes from [Hz]
    double high = 5000.0;   ///< to [Hz]; at most 0.45 of the rate
    std::size_t most = 64;  ///< strongest modes kept
    double skip = 0.005;    ///< of the beginning, in which the stick touches [s]
    double longest = 1.5;   ///< of each recording [s]
    double radius = 0.33;   ///< of the drum [m]
};

constexpr double kTypicalMass = 0.02;     // [kg]
constexpr double kTypicalImpulse = 0.04;  // [N s]
constexpr double kTypicalPressure = 5.0;  // [Pa]

struct MeasuredModes {
    GivenModes modes;
    std::vector<DecayingSine> sines;  ///< the same, lowest first
    /// Of each hit: amplitude of each mode at the stroke.
    std::vector<std::vector<std::complex<double>>> amplitudes;
    std::vector<std::size_t> begins;  ///< of each hit's stroke [samples]
    std::vector<double> left;         ///< of each hit: power not explained, over all, up to `high`
    std::size_t unknown_signs = 0;
};

/// Throws std::invalid_argument if there are no hits, one is too short or silent, places are not
/// from 0 to 1 and different, or no mode is found.
MeasuredModes modes_of_hits(std::span<const Hit> hits, double sample_rate,
                            const HitAnalysis& analysis);

/// Where the stroke of a recording begins [samples].
std::size_t stroke_begin(std::span<const double> samples, double sample_rate);

}  // namespace percussionist::modal
