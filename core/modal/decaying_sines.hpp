// Decaying sines found in recordings that share them: ESPRIT.
//
// Samples of a sum of K exponentials z_k^n, put into a matrix whose columns are windows of the
// signal, span a space of K dimensions that a shift by one sample turns by the z_k: they are the
// eigenvalues of the least squares solution of U_up = U_down Psi, U the leading eigenvectors of the
// windows' covariance. Recordings with the same z_k (a drum struck at several places) add their
// covariances, and are analysed as one. What is no larger than the noise's eigenvalues is left out.
// Source: Roy and Kailath, "ESPRIT", 1989; for sub-bands and drums, Laroche 1993; Badeau 2005.
//
// Allocates.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/modal/sub_band.hpp"

namespace percussionist::modal {

struct DecayingSine {
    double frequency = 0.0;  ///< [Hz]
    double loss = 0.0;       ///< s of exp(-s t) [1/s]
};

/// The decaying sines of bands of one centre and rate, within half their filter's width of the
/// centre.
std::vector<DecayingSine> decaying_sines(std::span<const SubBand> bands, double width);

}  // namespace percussionist::modal
