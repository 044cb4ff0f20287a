// Modes of what is round: membranes and free plates. Their shapes, and how they are heard afar.
//
// Mode (m, n), m nodal diameters and n nodal circles, has the shape
//     phi(r, theta) = (J_m(x r / R) + b exp(-x) I_m(x r / R)) cos(m theta)
// and, for m > 0, a second with sin(m theta). x is the mode's `root`; b is 0 on a membrane.
// A force F at (r, theta) accelerates the mode's amplitude q by F phi(r, theta) / modal_mass, and
// the displacement is sum q phi.
//
// Averaged over a disc of radius a, a wave of number k is 2 J_1(k a) / (k a) of that at the disc's
// centre (the mean value theorem of the Helmholtz equation; I_1 for the other term), wherever the
// disc does not reach over the rim.
//
// Far away, at the angle e from the axis and the azimuth theta, a baffled body is heard as
//     p = rho / (2 pi d) sum of q''(t - d / c) * integral of phi exp(i k s) dA,   k = w / c,
// s the path towards the listener (Rayleigh's integral); the integral is i^m times a real number
// (Lommel's integral of two Bessel functions): for odd m the mode is heard a quarter of its period
// later. Source: Morse and Ingard, "Theoretical Acoustics", 5.2 and 7.4.
//
// Nothing here throws. Without allocation.
#pragma once

#include <span>

namespace percussionist::modal {

struct RoundMode {
    int diameters = 0;               ///< m, nodal diameters
    int circles = 1;                 ///< n, nodal circles, the rim of a membrane being one
    bool sine = false;               ///< orientation: cos(m theta) or sin(m theta)
    double root = 0.0;               ///< x: wave number times radius
    double bend = 0.0;               ///< b
    double radius = 0.0;             ///< of the body [m]
    double angular_frequency = 0.0;  ///< [rad/s]
    double mass_fraction = 0.0;      ///< mean of phi^2 over the body
    double modal_mass = 0.0;         ///< [kg]

    /// The shape's value at a point (r [m], theta [rad]); 0 beyond the rim.
    [[nodiscard]] double shape(double r, double theta) const noexcept;
};

/// Where a body is touched: averaged over a disc about a point.
struct Spot {
    double r = 0.0;       ///< [m]
    double theta = 0.0;   ///< [rad]
    double spread = 0.0;  ///< radius of the disc [m]
};

/// Every mode's shape at a spot, in their order, what a pair shares taken once. `values` has room.
void evaluate_shapes(std::span<const RoundMode> modes, const Spot& spot,
                     std::span<double> values) noexcept;

/// The integral of phi exp(i k s) dA over i^m [m^2], heard at `elevation` [rad] from the axis.
double radiation(const RoundMode& mode, double elevation, double azimuth) noexcept;

constexpr double kSoundSpeed = 343.0;  ///< [m/s]

}  // namespace percussionist::modal
