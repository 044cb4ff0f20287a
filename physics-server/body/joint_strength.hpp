// What a joint's strength admits of a motion that is asked for.
//
// Inverse kinematics knows no masses: to keep a tip on its path while it turns within a few
// milliseconds it would have a whole arm swing forth and back with several times the torque that a
// shoulder has. Each joint follows what is asked for with the angular acceleration that its torque
// limit gives to what hangs on it,
//     |dw| <= h a,  a = torque limit / inertia,
// towards the velocity that closes the distance e to what is asked for and can still be stopped,
//     w = w_asked + e / |e| min(|e| / h, sqrt(a |e|)).
// A motion that is feasible goes through unchanged.
//
// Real-time safe once constructed; deterministic; one thread.
#pragma once

#include <vector>

#include "body/posture.hpp"

namespace percussionist::body {

/// The largest moment of inertia about the joint of `segment` of all that hangs on it, at rest
/// [kg m^2].
double hanging_inertia(const Skeleton& skeleton, int segment);

class JointStrength {
  public:
    /// `segments`: whose joints are held to their strength; steps of h [s].
    JointStrength(const Skeleton& skeleton, const std::vector<int>& segments, double h);

    /// The motion is at `now` and was at `before`, and follows what is asked for.
    void begin(const Posture& before, const Posture& now);
    /// `wish` is asked for in the next step. Holds it to what can be; whether anything changed.
    bool hold(Posture& wish);

  private:
    struct Joint {
        int segment;
        double most;  ///< change of a turn from step to step [rad]
    };
    std::vector<Joint> joints_;
    Posture asked_;         ///< in the last step
    Posture before_, now_;  ///< the motion that follows
};

}  // namespace percussionist::body
