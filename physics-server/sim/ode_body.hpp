// The skeleton in ODE: a rigid body for each segment but the pelvis, a ball joint and a motor for
// each of the 19 joints.
//
// The pelvis does not move: what hangs on it hangs on the world, so that ODE sees three islands
// (trunk with arms, either leg) and solves three small problems instead of one large one.
#pragma once

#include <vector>

#include "body/posture.hpp"
#include "sim/ode_world.hpp"

namespace percussionist::sim {

class OdeBody {
  public:
    /// Masses and inertias are the skeleton's times `mass_factor`.
    OdeBody(const body::Skeleton& skeleton, OdeWorld& world, double mass_factor = 1.0);

    /// Takes over the skeleton's masses and inertias, which have changed.
    void weigh();

    /// Puts every segment where `placement` has it, at rest.
    void place(const body::Placement& placement);
    /// Gives every segment the velocity with which it comes from `before` to `after` in `time` [s].
    void set_velocities(const body::Placement& before, const body::Placement& after, double time);
    /// Where the segments are now.
    void read(body::Placement& placement) const;

    [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }
    /// Null for the pelvis.
    [[nodiscard]] dBodyID segment(int index) const { return segments_[index]; }
    [[nodiscard]] dBodyID parent(int index) const {
        return segments_[skeleton_.segments[index].parent];
    }
    [[nodiscard]] dJointID motor(int index) const { return motors_[index]; }

    /// Adds a torque [N m, world] between a segment and its parent, for the step to come.
    void add_joint_torque(int index, const Vector3& torque);
    /// What a motor exerted on its segment in the last step [N m, world].
    [[nodiscard]] Vector3 motor_torque(int index) const { return vector(feedback_[index].t1); }

    [[nodiscard]] Vector3 tip_position(body::Hand hand) const;
    [[nodiscard]] Vector3 tip_velocity(body::Hand hand) const;
    /// A force [N, world] on the middle of the tip, for the step to come.
    void add_tip_force(body::Hand hand, const Vector3& force);
    /// True while every coordinate is finite and within reach of a room.
    [[nodiscard]] bool sane() const;

  private:
    struct Tip {
        dBodyID stick;
        Vector3 offset;  ///< from the stick's centre of mass, its own frame
    };
    [[nodiscard]] const Tip& tip(body::Hand hand) const { return tips_[static_cast<int>(hand)]; }

    const body::Skeleton& skeleton_;
    double mass_factor_;
    std::vector<dBodyID> segments_;
    std::vector<dJointID> joints_, motors_;
    std::vector<dJointFeedback> feedback_;  ///< of the motors
    Tip tips_[2];
};

}  // namespace percussionist::sim
