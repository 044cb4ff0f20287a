// What is wrong with captured motion, mended before a body follows it.
//
// Of a path: see path_repair.hpp. Of joints: a first frame that is no part of the
// motion (a T-pose) is left out; frames repeated by a slower source are spread; a joint that jumps
// for a frame is bridged; none turns faster than 60 rad/s.
//
// Each repair is counted, to be told. Values; allocates.
#pragma once

#include <string>
#include <vector>

#include "core/motion/capture.hpp"

namespace percussionist::body {

struct Repairs {
    int bridged = 0;     ///< samples of a path, or rotations of a joint, that were glitches
    int repeated = 0;    ///< frames that repeated the one before
    int slowed = 0;      ///< rotations that were too fast
    int first_left = 0;  ///< frames left out at the beginning
    /// In words, without what did not happen; empty if nothing did.
    [[nodiscard]] std::string describe() const;
};

/// Mends rotations, [frame * joints + joint], `frame_time` [s] apart. Signs are made continuous.
Repairs repair_rotations(std::vector<linear::Quaternion>& rotations, std::size_t joints,
                         double frame_time);

}  // namespace percussionist::body
