// What is told of a stick's contact with a head, in the head's own frame.
#pragma once

#include "body/skeleton.hpp"
#include "body/touch.hpp"

namespace percussionist::sim {

/// Its instant is in simulated time.
struct ContactEvent : body::Touch {
    body::Hand hand = body::Hand::left;
    int drum = 0;
    bool recontact = false;  ///< within the rest after the stroke before
};

}  // namespace percussionist::sim
