// A hand on the head: flesh that is pressed against it, springy and lossy.
//
// Over the area it covers, flesh answers the head's motion u with a pressure k u + r u', fitted to
// each mode by its shape there: it damps what moves under it, and stiffens it, so that the pitch
// rises. Soft tissue grows stiffer in proportion to the load it bears (Fung, "Biomechanics"): k is
// the pressure over kFleshDepth. Its resistance is about the wave impedance of soft tissue, reached
// as the skin comes to lie against the head. Flesh that is held still gives way: its stress relaxes
// (Fung's reduced relaxation function), here with one time constant, as a spring in series with a
// damper does, a Maxwell body. So a hand that came to lie on a swinging head ends at rest where the
// head does. Depth, impedance, relaxation and the pressure that seats the skin are our choice, of
// the right order of magnitude; not measured on a drum.
//
// Values only: may be used anywhere.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/modal/round_modes.hpp"

namespace percussionist::modal {

struct Hand {
    double r = 0.1;            ///< its middle [m]
    double theta = 0.0;        ///< [rad]
    double area = 0.004;       ///< [m^2]: a fingertip 1e-4, a palm 6e-3
    double pressure = 3000.0;  ///< [Pa]
};

/// Throws std::invalid_argument unless r and pressure (up to 1e6) are finite and 0 or more, area is
/// above 0 and at most 0.1, theta finite.
void check(const Hand& hand);

/// In which the stress of flesh that is held still falls to 1/e [s].
constexpr double kFleshRelaxation = 0.05;

/// A hand is felt as one to four round spots beside each other.
struct HandPoints {
    static constexpr std::size_t kMost = 4;
    std::array<Spot, kMost> spots;
    std::size_t count = 0;
    double stiffness = 0.0;   ///< of each [N/m]
    double resistance = 0.0;  ///< of each [N s/m]
};

HandPoints points_of(const Hand& hand) noexcept;

}  // namespace percussionist::modal
