// Captured motion as it comes out of a file: a tree of joints of any names, and its rotations frame
// by frame; and the path of a rigid thing (a stick, its tip).
//
// Plain values. Lengths of a Capture are in the file's own unit, which body/retarget.hpp makes
// metres; a Trajectory is in SI units.
#pragma once

#include <string>
#include <vector>

#include "core/linear/rotation.hpp"

namespace percussionist::motion {

using linear::Quaternion;
using linear::Vector3;

struct CapturedJoint {
    std::string name;
    int parent = -1;  ///< index, below this joint's own; -1: a root
    Vector3 offset =
        Vector3::Zero();  ///< from the parent's joint, in the parent's frame [file's unit]
    bool end = false;     ///< the end of a limb: it has a place, and no rotation
};

struct Capture {
    std::string name;         ///< of the file
    double frame_time = 0.0;  ///< [s]
    std::vector<CapturedJoint> joints;
    std::vector<Quaternion> rotations;  ///< against the parent; [frame * joints.size() + joint]
    std::vector<std::string> warnings;  ///< what was wrong and read all the same

    [[nodiscard]] std::size_t frames() const {
        return joints.empty() ? 0 : rotations.size() / joints.size();
    }
    [[nodiscard]] const Quaternion& rotation(std::size_t frame, std::size_t joint) const {
        return rotations[frame * joints.size() + joint];
    }
};

struct TrajectorySample {
    double time = 0.0;                   ///< [s]
    Vector3 position = Vector3::Zero();  ///< [m], z up
    Quaternion rotation = Quaternion::Identity();
};

struct Trajectory {
    std::string name;
    std::vector<TrajectorySample> samples;  ///< times ascending
    bool has_rotation = false;
    std::vector<std::string> warnings;
};

}  // namespace percussionist::motion
