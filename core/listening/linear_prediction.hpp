// Linear prediction: what of a signal its recent past does not explain.
//
// A sum of decaying partials obeys x[n] = sum a_k x[n-k]; the a_k are found by least squares over a
// stretch of the signal (the covariance method, exact for decaying partials, unlike those that
// assume a stationary signal). The residual x[n] - sum a_k x[n-k] is then what was put in from
// outside: next to nothing while a drum rings, and the stroke itself when it is struck.
// Source: Makhoul 1975, "Linear prediction: a tutorial review".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::listening {

constexpr int kPredictionOrder = 32;

/// The coefficients a_1..a_order that best predict signal[begin, end), samples before the signal
/// counting as 0. All 0 for silence.
std::vector<double> predictor(std::span<const double> signal, std::size_t begin, std::size_t end);

/// The residual at signal[begin, end).
std::vector<double> residual(std::span<const double> signal, std::span<const double> predictor,
                             std::size_t begin, std::size_t end);

}  // namespace percussionist::listening
