// The ideal circular membrane: its modes, out of its radius, tension and density.
//
// A mode (m, n), m nodal diameters and n nodal circles (the rim counts), swings at
//     f_mn = j_mn / (2 pi R) sqrt(T / sigma)
// where j_mn is the n-th positive zero of the Bessel function J_m, in the shape
//     phi(r, theta) = J_m(j_mn r / R) cos(m theta)   and, for m > 0, a second with sin(m theta).
// The integral of sigma phi^2 over the head is the modal mass, so that a force F at (r, theta)
// accelerates the mode's amplitude q by F phi(r, theta) / modal_mass, and the head's displacement
// is sum q phi. Source: Morse and Ingard, "Theoretical Acoustics", 5.2.
//
// Pure functions; they allocate (the returned vector): not for the audio thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::modal {

struct Membrane {
    double radius = 0.33;            ///< [m]
    double tension = 3500.0;         ///< [N/m]
    double surface_density = 0.262;  ///< [kg/m^2]
};

/// Throws std::invalid_argument unless radius, tension and density are finite and above 0.
void check(const Membrane& membrane);

struct MembraneMode {
    int diameters = 0;               ///< m, nodal diameters
    int circles = 1;                 ///< n, nodal circles, the rim being one
    bool sine = false;               ///< orientation: cos(m theta) or sin(m theta)
    double bessel_zero = 0.0;        ///< j_mn
    double radius = 0.0;             ///< of the membrane [m]
    double angular_frequency = 0.0;  ///< [rad/s]
    double mass_fraction = 0.0;      ///< modal mass over the membrane's mass
    double modal_mass = 0.0;         ///< [kg]

    /// The shape's value at a point of the head (r [m], theta [rad]); 0 at and beyond the rim.
    [[nodiscard]] double shape(double r, double theta) const;
};

/// The n-th positive zero of J_m (m >= 0, n >= 1), to the last digits.
double bessel_zero(int m, int n);

/// The `count` lowest modes, lowest first, both orientations of a pair beside each other.
/// Throws as check().
std::vector<MembraneMode> membrane_modes(const Membrane& membrane, std::size_t count);

/// Every mode's shape at one point, in their order, the Bessel function of a pair taken once.
/// `values` has room for them.
void evaluate_shapes(std::span<const MembraneMode> modes, double r, double theta,
                     std::span<double> values);

/// The same modes on another membrane: their order and shapes (over r / radius) are those of every
/// membrane, so that no Bessel function is needed. Does not allocate; throws as membrane_modes().
void retune(std::vector<MembraneMode>& modes, const Membrane& membrane);

}  // namespace percussionist::modal
