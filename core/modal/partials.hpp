// How strongly known decaying sines sound in a recording: least squares, all at once.
//
// x[n] = Re sum a_k z_k^n, z_k = exp((-s_k + i 2 pi f_k) / rate). The sums over n of products of
// the z_k are geometric, so that the normal equations cost no more than the products with the
// recording. Allocates.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/modal/decaying_sines.hpp"

namespace percussionist::modal {

/// a_k of each sine, at the recording's first sample.
std::vector<std::complex<double>> amplitudes(std::span<const DecayingSine> sines,
                                             std::span<const double> recording, double sample_rate);

/// The sum they make.
std::vector<double> resynthesis(std::span<const DecayingSine> sines,
                                std::span<const std::complex<double>> amplitudes,
                                std::size_t length, double sample_rate);

}  // namespace percussionist::modal
