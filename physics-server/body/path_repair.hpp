// Glitches of a recorded path: samples that jump away and come back, a marker lost or taken for
// another. They are left out; a curve through what stays bridges them.
//
// What a stick does and what a glitch does are told apart by continuity. Over a step of dt from one
// sample to the next a tip moves by a mixture of its velocities before and after, however hard it
// strikes within the step; a glitch adds a jump. So a run of samples is a glitch if
//   - on the step into it, and on that out of it, the path is farther than a tolerance from all
//     mixtures of v_before dt and v_after dt;
//   - its first and its last sample are as far from all that could lie there: from the path before
//     drawn on, the path after drawn back, the chord between, and what these span.
// A turn within one step passes, at any speed. The tolerance is a floor, what the noise of the path
// (the median of its third differences) makes likely, and what a tip may be accelerated by.
//
// A path that stays elsewhere for longer than 0.12 s is there. What jumps at either end, and does
// not stay, is left out. Values; allocates.
#pragma once

#include "body/repair.hpp"

namespace percussionist::body {

/// Leaves out the glitches of a path; times ascend.
Repairs repair(motion::Trajectory& path);

/// The noise of a path per axis, from its third differences [m].
double path_noise(const motion::Trajectory& path);

}  // namespace percussionist::body
