// What is felt where one thing strikes another: plain values, SI units, the frame of what is struck
// (origin in its middle, z out of it towards the striker, x to the player's front).
#pragma once

#include "core/linear/rotation.hpp"

namespace percussionist::body {

struct Touch {
    double instant = 0.0;                                  ///< of the first touch [s]
    linear::Vector3 place = linear::Vector3::Zero();       ///< on what is struck [m]
    linear::Vector3 velocity = linear::Vector3::Zero();    ///< of the striker just before [m/s]
    linear::Vector3 peak_force = linear::Vector3::Zero();  ///< on what is struck [N]
    double impulse = 0.0;                                  ///< on what is struck [N s]
    double duration = 0.0;                                 ///< from first touch to last [s]
    double effective_mass = 0.0;  ///< of the striker, along the normal [kg]
};

}  // namespace percussionist::body
