// The circular membrane: its modes, out of what it is made of.
//
// Ideal, mode (m, n) swings at w = k sqrt(T / sigma), k = j_mn / R, where j_mn is the n-th positive
// zero of the Bessel function J_m, in the shapes of round_modes.hpp; its modal mass is the integral
// of sigma phi^2. Source: Morse and Ingard, "Theoretical Acoustics", 5.2. What makes it less ideal:
//     bending     w^2 = (T k^2 + D k^4) / sigma. The shapes stay (at a rim that lets the skin
//     turn). air         the air moved along adds 2 rho / sqrt(k^2 - (w/c)^2) to sigma: the wave in
//     the
//                 skin is slower than sound and moves but the air near it, on both sides. Taken of
//                 an endless membrane; lowers the low modes most (timpani: Rossing 1982).
//     cavity      a closed shell of volume V stiffens modes without diameters by
//                 rho c^2 (integral of phi)^2 / V; what couples these modes to each other is left
//                 out.
//     stretch     S = E h / (1 - nu^2) [N/m]: a swinging skin is longer, hence tighter, by
//                 dT = S / (2 A) * integral of |grad u|^2 (Berger 1955). See tension.hpp.
//
// The functions allocate but for retune(): not for the audio thread.
#pragma once

#include <cstddef>
#include <vector>

#include "core/modal/round_modes.hpp"

namespace percussionist::modal {

struct Membrane {
    double radius = 0.33;            ///< [m]
    double tension = 3500.0;         ///< [N/m]
    double surface_density = 0.262;  ///< [kg/m^2]
    double bending = 0.0;            ///< D, stiffness of the skin [N m]
    double air_density = 0.0;        ///< rho [kg/m^3]; 0: in a vacuum, real air 1.2
    double cavity = 0.0;             ///< V [m^3], with air in it; 0: open
    double stretch = 0.0;            ///< S [N/m]; 0: the tension stays as it is
};

/// Throws std::invalid_argument unless radius, tension and density are finite and above 0, all else
/// finite and 0 or more.
void check(const Membrane& membrane);

/// The n-th positive zero of J_m (0 <= m <= 200, n >= 1, below 210), to the last digits.
double bessel_zero(int m, int n);

constexpr std::size_t kMostModes = 8192;

/// The `count` lowest modes (at most kMostModes), lowest first, both orientations of a pair beside
/// each other. Throws as check().
std::vector<RoundMode> membrane_modes(const Membrane& membrane, std::size_t count);

/// The same modes on another membrane: their order and shapes (over r / radius) are those of every
/// membrane, so that no Bessel function is needed. Does not allocate; throws as membrane_modes().
void retune(std::vector<RoundMode>& modes, const Membrane& membrane);

}  // namespace percussionist::modal
