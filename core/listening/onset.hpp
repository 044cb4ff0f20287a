// When drum strokes begin to sound, to well under a millisecond, while earlier ones still ring.
//
// What rings on is smooth: a few low, decaying partials. What begins is sudden, and rich in high
// frequencies for its first milliseconds. So the signal is differentiated, which leaves
// the attacks and takes the ringing down by 12 dB an octave; its energy in short frames is
// compared with that of the frames just before; where it leaps, a stroke begins. The instant is
// then refined to the sample at which the attack rises out of what was there before.
//
// Blind search and search near known instants use the same measure. Pure functions; they allocate.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percussionist::listening {

struct OnsetOptions {
    double rise = 3.0;           ///< times the energy before, at least
    double floor = 1e-5;         ///< energy of an onset over that of the loudest, at least
    double min_interval = 0.02;  ///< between two onsets [s]
};

struct Onset {
    double time = 0.0;      ///< from the first sample [s]
    double strength = 0.0;  ///< peak of the attack's energy, in the signal's units squared
};

/// The onsets of `signal` (mono, `rate` in Hz), in order of time.
std::vector<Onset> find_onsets(std::span<const double> signal, double rate,
                               const OnsetOptions& options = {});

/// For each of `times` [s] the onset nearest to it, at most `window` [s] away, or none.
std::vector<std::optional<double>> onsets_near(std::span<const double> signal, double rate,
                                               std::span<const double> times, double window);

struct OnsetMatch {
    struct Pair {
        std::size_t expected = 0;  ///< index
        std::size_t found = 0;     ///< index
        double error = 0.0;        ///< found - expected - offset [s]
    };
    double offset = 0.0;  ///< median of found - expected: what is constant (latency) [s]
    std::vector<Pair> pairs;
    double median_error = 0.0;        ///< of |error| [s]
    double worst_error = 0.0;         ///< of |error| [s]
    std::vector<std::size_t> missed;  ///< expected, not found
    std::vector<std::size_t> extra;   ///< found, not expected
};

/// Pairs off two lists of times in order [s], each with at most one of the other and no more than
/// `tolerance` [s] away once the constant offset, at most `tolerance` too, is taken out.
OnsetMatch match(std::span<const double> expected, std::span<const double> found, double tolerance);

}  // namespace percussionist::listening
