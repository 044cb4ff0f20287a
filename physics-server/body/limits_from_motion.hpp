// Joint limits from what a joint was seen to do.
//
// Euler: the 99.5 % of each angle z y x that lie in the middle, widened by 5 %.
//
// Quaternion (Algorithm 1 of the 2009 paper), with what it leaves open settled so:
//   1. the mean is the dominant eigenvector of the sum of q q^T; samples on its other side flip
//   sign;
//   2. v = log(mean^-1 q); the singular value decomposition of all v gives axes and deviations s;
//   3. d = |axes^T v / s|; the semi-axes are k s with k = 1.05 times the 99.5th percentile of d:
//   the
//      largest d would let a single T-pose frame treble it.
// Deviations are at least a degree (a hinge has none across), semi-axes below pi.
#pragma once

#include <vector>

#include "body/joint_limits.hpp"

namespace percussionist::body {

/// Throws std::invalid_argument for no rotations.
JointLimits euler_limits(const std::vector<Quaternion>& rotations);
JointLimits ellipsoid_limits(const std::vector<Quaternion>& rotations);

/// The box that also holds the rotations.
JointLimits widened(const JointLimits& box, const std::vector<Quaternion>& rotations);

/// The share of all rotations that the limits let through, by as many random ones; always the same.
double admitted_share(const JointLimits& limits, int samples);

}  // namespace percussionist::body
