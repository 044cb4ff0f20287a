// From a captured skeleton of any make to ours: its lengths, and its motion as postures of our
// body.
//
// Files agree neither on the pose in which all rotations are zero nor on the axes of a joint, so
// that neither is used. Each of our segments gets an anatomical frame out of the motion itself: the
// bone's direction, which the file says exactly, and an axis across it, averaged over the frames in
// the captured joint's own frame: the axis about which elbow or knee bends, the line through hips
// or shoulders. What turns that frame into the captured joint's is constant; with it every rotation
// of the file, twists included, becomes one of ours. The pelvis, which our body has fixed, is the
// frame of everything; on average it is upright.
//
// The unit of length is the one (m, cm, mm, inch, the CMU's 0.45th of an inch) with which the
// body's stature is nearest to 1.7 m, unless it is said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "body/posture.hpp"
#include "body/repair.hpp"
#include "body/skeleton.hpp"
#include "body/skeleton_map.hpp"

namespace percussionist::body {

struct RetargetOptions {
    double unit = 0.0;  ///< of lengths in the file [m]; 0: find out
    double mass = 0.0;  ///< of the body [kg]; 0: from the stature, at 24.5 kg/m^2
    Stick stick;
};

struct RetargetedMotion {
    Anthropometry person;           ///< whose lengths are the captured ones
    std::vector<Posture> postures;  ///< of make_skeleton(person)
    double frame_time = 0.0;        ///< [s]
    double unit = 1.0;              ///< that was taken [m]
    Repairs repairs;
    std::vector<std::string> remarks;  ///< lengths that were not to be had, and the like
};

/// Throws std::invalid_argument if the capture has no frame.
RetargetedMotion retarget(const motion::Capture& capture, const SkeletonMatch& match,
                          const RetargetOptions& options = {});

}  // namespace percussionist::body
