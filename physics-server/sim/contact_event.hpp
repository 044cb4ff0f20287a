// What is told of a stick's contact with a head: plain values, SI units, the head's own frame
// (origin in the middle of the head, z out of it towards the player's stick, x to the player's
// front).
#pragma once

#include "body/skeleton.hpp"

namespace percussionist::sim {

struct ContactEvent {
    body::Hand hand = body::Hand::left;
    int drum = 0;
    double instant = 0.0;                                ///< of the first touch, simulated time [s]
    linear::Vector3 place = linear::Vector3::Zero();     ///< on the head [m]
    linear::Vector3 velocity = linear::Vector3::Zero();  ///< of the tip just before [m/s]
    linear::Vector3 peak_force = linear::Vector3::Zero();  ///< on the head [N]
    double impulse = 0.0;                                  ///< on the head [N s]
    double duration = 0.0;                                 ///< from first touch to last [s]
    double effective_mass = 0.0;  ///< of the tip, along the head's normal [kg]
    bool recontact = false;       ///< within the rest after the stroke before
};

}  // namespace percussionist::sim
