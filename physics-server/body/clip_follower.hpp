// A clip as targets for a body: its postures, or its tips alone.
//
// From the tips alone the posture is not known. Of a captured body it is looked for about the one
// that the body usually has with its tips there (posture_habit.hpp). Where sticks alone were
// recorded, the height of a grip is taken to go a share of the way of its tip, smoothed, about its
// height in the clip's mean posture.
//
// Building allocates; reading allocates nothing.
#pragma once

#include <memory>
#include <optional>

#include "body/clip.hpp"
#include "body/inverse_kinematics.hpp"
#include "body/posture_habit.hpp"

namespace percussionist::body {

/// What of a motion is followed: its joints (the papers' inverse dynamics alone), or its tips
/// (their hybrid of inverse kinematics and inverse dynamics).
enum class Tracking { joints, tips };

class ClipFollower {
  public:
    /// `skeleton`, which has to outlive it, is the clip's.
    ClipFollower(std::shared_ptr<const Clip> clip, const Skeleton& skeleton);

    /// At t from the clip's beginning [s].
    void posture(double t, Posture& posture, Placement& placement) const;
    /// `placement` is that of the clip's posture at t.
    [[nodiscard]] Vector3 tip(double t, Hand hand, const Placement& placement) const;
    /// And the posture that inverse kinematics is to be pulled to.
    [[nodiscard]] ArmTargets targets(double t, Posture& rest) const;

    [[nodiscard]] const Clip& clip() const { return *clip_; }

  private:
    std::shared_ptr<const Clip> clip_;
    const Skeleton& skeleton_;
    std::optional<PostureHabit> habit_;  ///< of a captured body
    Spline grip_heights_;                ///< of sticks alone: left, right
    void fill_grip_heights();
    mutable Posture posture_;  ///< memory for targets()
    mutable Placement placement_;
};

}  // namespace percussionist::body
