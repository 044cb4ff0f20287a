// Joint limits from what a joint was seen to do.
//
// Euler: the range of each angle z y x, widened by 5 %.
//
// Quaternion (Algorithm 1 of the 2009 paper), with what it leaves open settled so:
//   1. the mean is the dominant eigenvector of the sum of q q^T; samples on its other side flip
//      sign;
//   2. v = log(mean^-1 q); the singular value decomposition of all v gives axes and deviations s;
//   3. d = |axes^T v / s|; the semi-axes are k s with k = 1.05 times the largest d.
// Limits admit the motion that they are learnt from. A frame that stands alone, though, counts no
// more than its neighbours: a single T-pose would treble k.
// Deviations are at least a degree (a hinge has none across), semi-axes below pi.
#pragma once

#include <vector>

#include "body/joint_limits.hpp"

namespace percussionist::body {

/// From rotations in their order in time. Throws std::invalid_argument for none.
JointLimits euler_limits(const std::vector<Quaternion>& rotations);
JointLimits ellipsoid_limits(const std::vector<Quaternion>& rotations);

/// The box that also holds the rotations.
JointLimits widened(const JointLimits& box, const std::vector<Quaternion>& rotations);

/// The share of all rotations that the limits let through, by as many random ones; always the same.
double admitted_share(const JointLimits& limits, int samples);

}  // namespace percussionist::body
