// The body that a captured skeleton belongs to: its unit of length, its limbs, its stature and
// mass.
//
// Masses, centres and inertias then follow from anthropometry (skeleton.hpp) with these lengths.
#pragma once

#include <string>
#include <vector>

#include "body/skeleton.hpp"
#include "body/skeleton_map.hpp"

namespace percussionist::body {

struct CapturedLengths {
    Anthropometry person;
    double unit = 1.0;                 ///< of the file [m]
    std::vector<std::string> remarks;  ///< which lengths are no body's and were taken from stature
};

/// `unit` [m], 0: the one with which the stature is nearest to 1.7 m.
CapturedLengths captured_lengths(const motion::Capture& capture, const SkeletonMatch& match,
                                 double unit);

}  // namespace percussionist::body
