// A motion to follow: postures and places of both stick tips at any time.
//
// A captured posture says both (the tips by forward kinematics); a recording of sticks alone says
// where the tips are, and a posture that puts them there is found beforehand by inverse kinematics.
// Between samples it is smooth (spline.hpp); before its first sample and after its last it glides
// to rest.
//
// Building allocates; reading is pure and real-time safe.
#pragma once

#include <array>
#include <string>

#include "body/posture.hpp"
#include "body/spline.hpp"
#include "core/motion/capture.hpp"

namespace percussionist::body {

class Clip {
  public:
    /// From postures `frame_time` [s] apart, signs of quaternions continuous.
    Clip(std::string name, const Skeleton& skeleton, const std::vector<Posture>& postures,
         double frame_time);

    /// Gives it tips of its own, by Hand [world, m]; times as those of the postures.
    void set_tips(std::array<Spline, 2> tips) { tips_ = std::move(tips); }

    /// From the first sample [s]; `posture` is of the clip's skeleton.
    void posture(double t, Posture& posture) const;
    /// Whether the tips were recorded, not computed from the postures.
    [[nodiscard]] bool has_own_tips() const { return !tips_[0].empty(); }
    /// The middle of a tip as it was recorded, world [m]; only if has_own_tips().
    [[nodiscard]] Vector3 own_tip(double t, Hand hand) const;

    [[nodiscard]] double duration() const { return joints_.end(); }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::vector<double>& times() const { return joints_.times(); }
    /// The posture about which it moves: each joint's mean rotation.
    [[nodiscard]] const Posture& mean() const { return mean_; }

  private:
    std::string name_;
    Spline joints_;  ///< four numbers a joint
    std::array<Spline, 2> tips_;
    Posture mean_;
};

/// The mean of rotations: the dominant eigenvector of the sum of q q^T, indifferent to signs
/// (Markley 2007, "Averaging quaternions"). Identity of none.
Quaternion mean_rotation(const std::vector<Quaternion>& rotations);

}  // namespace percussionist::body
