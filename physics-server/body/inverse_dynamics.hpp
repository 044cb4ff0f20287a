// Inverse dynamics: the torques that make the body follow a motion, and the mass that its stick's
// tip shows to a drum.
//
// Newton and Euler along the tree: a joint carries the inertial forces of all that hangs on it,
//     tau_j = sum over segments k above j of (c_k - p_j) x m_k (a_k - g) + d(I_k w_k)/dt.
// Accelerations come from three placements one step apart (central differences), so that a target
// given by inverse kinematics needs no derivative of its own. Featherstone 2008, ch. 5.
//
// No allocation after construction; deterministic; one thread.
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "body/posture.hpp"

namespace percussionist::body {

/// The acceleration of each segment.
struct Acceleration {
    std::vector<Vector3> linear;    ///< of the centre of mass, world [m/s^2]
    std::vector<Vector3> momentum;  ///< d(I w)/dt about the centre of mass, world [N m]
    explicit Acceleration(const Skeleton& skeleton)
        : linear(skeleton.segments.size(), Vector3::Zero()),
          momentum(skeleton.segments.size(), Vector3::Zero()) {}
};

/// From placements at t - h, t and t + h, h [s].
void central_difference(const Skeleton& skeleton, const Placement& before, const Placement& now,
                        const Placement& after, double h, Acceleration& acceleration);

/// The torque [N m], world frame, that each joint exerts on its segment (and takes from its parent)
/// to move so under gravity. Entry 0, the pelvis, is what holds it and is not computed.
void joint_torques(const Skeleton& skeleton, const Placement& now, const Acceleration& acceleration,
                   std::vector<Vector3>& torques);

/// The effective mass [kg] of a stick's tip along a unit `normal`, 1 / (n^T J M^-1 J^T n), for a
/// body whose joints answer within a step of h as implicit springs: to the joint-space inertia M of
/// the chain from pelvis to stick is added `resistance` [kg m^2] on each axis of each joint
/// (h kd + h^2 kp; zeros for the bare body). Holds memory for its work.
class TipMass {
  public:
    TipMass(const Skeleton& skeleton, Hand hand);
    double operator()(const Placement& now, const Vector3& normal,
                      const std::vector<double>& resistance);

  private:
    const Skeleton& skeleton_;
    Hand hand_;
    std::vector<int> chain_;  ///< from the stick down to the first segment above the pelvis
    Eigen::MatrixXd inertia_;
    Eigen::VectorXd reach_;
    Eigen::LLT<Eigen::MatrixXd> factors_;
};

}  // namespace percussionist::body
