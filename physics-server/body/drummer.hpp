// The body of a drummer who sits at a kit: how tall, on what seat, with which feet on which pedals.
//
// The pelvis is where the seat puts it, a little tilted; back and neck are upright; the hands wait
// above the snare. A leg is two rods and a hinge: with the ankle given, the knee lies on a circle,
// where it points forward and somewhat outward. A foot lies flat on its pedal's plate and turns
// with it about the heel; one that has no pedal stands beside.
//
// Values; building allocates.
#pragma once

#include "body/posture.hpp"
#include "core/score/kit.hpp"

namespace percussionist::body {

/// The part of a body that strikes.
struct LimbParts {
    std::vector<int> segments;  ///< whose joints it moves, from the trunk outwards
};
LimbParts parts_of(const Skeleton& skeleton, score::Limb limb);

/// The skeleton of a kit's drummer, its hips at the height of his seat. Throws
/// std::invalid_argument as make_skeleton().
Skeleton make_drummer(const score::Drummer& drummer);

/// Sitting, the feet on pedals that are let go by `up` (0: pressed, 1: up), by left and right.
Posture seated(const Skeleton& skeleton, const score::Kit& kit, double left_up, double right_up);

/// The leg's joints for a foot on its pedal. Returns how far the foot stays from it [m]: 0 if the
/// leg is long enough.
double put_foot(const Skeleton& skeleton, const score::Kit& kit, score::Limb foot, double up,
                Posture& posture);

/// Where the ball of the foot is, at the sole, world [m].
Vector3 ball_of(const Skeleton& skeleton, const Placement& placement, score::Limb foot);
/// Where on its pedal's plate the ball lies when the plate is let go by `up`, world [m].
Vector3 plate_point(const score::Pedal& pedal, double up);

/// How far the plate under the foot is let go: 0 pressed, 1 up.
double pedal_up(const Skeleton& skeleton, const Placement& placement, const score::Pedal& pedal);

}  // namespace percussionist::body
