// The free circular plate: a cymbal, as far as a flat one is.
//
// Kirchhoff's plate of thickness h, D = E h^3 / (12 (1 - nu^2)): mode (m, n) swings at
//     w = (x / R)^2 sqrt(D / (rho h)),
// x a root of the condition that neither bending moment nor shear force act on the free edge, in
// the shapes of round_modes.hpp. Rigid motions are left out: a cymbal's stand holds it.
// Source: Leissa, "Vibration of Plates", 1969, 2.1.3; for nu = 0.33, x^2 = 5.25, 9.08, 12.2, 20.5.
//
// The functions allocate but for retune().
#pragma once

#include <cstddef>
#include <vector>

#include "core/modal/round_modes.hpp"

namespace percussionist::modal {

/// The default: 16 inches of bronze, 1 mm thick.
struct Plate {
    double radius = 0.2032;     ///< [m]
    double thickness = 0.001;   ///< h [m]
    double stiffness = 1.1e11;  ///< Young's modulus E [Pa]
    double density = 8600.0;    ///< rho [kg/m^3]
    double poisson = 0.33;      ///< nu, 0 to 0.5
};

/// Throws std::invalid_argument naming the field.
void check(const Plate& plate);

/// The `count` lowest modes, as membrane_modes(). Their shapes depend on `poisson`.
std::vector<RoundMode> plate_modes(const Plate& plate, std::size_t count);

/// The same modes on a plate of the same `poisson`. Does not allocate; throws as check().
void retune(std::vector<RoundMode>& modes, const Plate& plate);

}  // namespace percussionist::modal
