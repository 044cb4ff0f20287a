// When drum strokes begin to sound, to well under a millisecond, while earlier ones still ring.
//
// A drum that rings is predictable: a sum of decaying partials, each sample a weighted sum of the
// ones before (linear_prediction.hpp). What no past explains is a stroke. So, every 2 ms, weights
// are learnt from the last 30 ms and tried on the next 2: where the energy of what they leave
// unexplained leaps, something struck. Weights learnt from the 30 ms after that know the partials
// of the ringing both before and after, and leave the force of the stroke alone; the onset is where
// that first reaches a fifth of its peak. A fraction of the peak, not a fixed threshold: a soft
// stroke is not found later than a loud one.
//
// Limits: the softer the mallet and the louder what rings, the less of a soft stroke is to be
// found blindly: with a stick, 30 dB below the stroke before it, with soft felt some 10 dB
// (docs/measurements.md). Who knows when to listen (onsets_near) hears more.
//
// Pure functions; they allocate.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percussionist::listening {

struct OnsetOptions {
    double rise = 6.0;           ///< of the unexplained energy, to look closer
    double contrast = 7.0;       ///< peak amplitude of the stroke's force over what was before it
    double floor = 1e-9;         ///< strength over that of the strongest onset, at least
    double min_interval = 0.02;  ///< between two onsets [s]
};

struct Onset {
    double time = 0.0;      ///< from the first sample [s]
    double strength = 0.0;  ///< peak of the stroke's force, squared, in the signal's units
};

/// The onsets of `signal` (mono, `rate` of 12000 Hz or more), in order of time.
std::vector<Onset> find_onsets(std::span<const double> signal, double rate,
                               const OnsetOptions& options = {});

/// For each of `times` [s] the onset nearest to it, at most `window` [s] away, or none. Where
/// there is none it listens more sharply than find_onsets does; what is 30 dB below another onset
/// in the window does not count.
std::vector<std::optional<double>> onsets_near(std::span<const double> signal, double rate,
                                               std::span<const double> times, double window);

}  // namespace percussionist::listening
