// Inverse kinematics by damped least squares: from the places of both stick tips to joint targets.
//
// Each arm has two tasks: its tip's place (x y z) and, softer, the height of its grip, so that the
// stick swings about a hand that moves smoothly. With the Jacobian J of the tasks, a diagonal W
// that says how readily each joint moves, and a pull z towards the rest posture,
//     dq = W J^T (J W J^T + lambda^2)^-1 (e - J z) + z.
// Wampler 1986; the pull projected as in Siciliano and Slotine 1991. A few iterations from the last
// solution follow a moving target; joint limits clamp the result.
//
// One instance a body, one thread. solve() allocates nothing; deterministic.
#pragma once

#include <array>
#include <vector>

#include "body/posture.hpp"

namespace percussionist::body {

struct ArmTarget {
    Vector3 tip = Vector3::Zero();  ///< middle of the stick's tip, world [m]
    double grip_height = 0.0;       ///< of the grip, world [m]
};
using ArmTargets = std::array<ArmTarget, 2>;  ///< by Hand

struct InverseKinematicsOptions {
    int iterations = 3;
    double damping = 0.002;    ///< lambda, of the tip tasks [m]
    double grip_weight = 0.3;  ///< of the grip's height against the tip's place
    double rest_pull = 0.002;  ///< share of the way to rest, each iteration
};

class InverseKinematics {
  public:
    explicit InverseKinematics(const Skeleton& skeleton, InverseKinematicsOptions options = {});

    /// Moves `posture` (from the last solution) towards the targets; returns the larger of the two
    /// tips' remaining errors [m]. `placement` is that of the new posture.
    double solve(const ArmTargets& targets, Posture& posture, Placement& placement);

    /// Where the grip is, world [m].
    [[nodiscard]] Vector3 grip(const Placement& placement, Hand hand) const;

  private:
    struct Column {
        int segment;
        Vector3 weight;             ///< of rotation about its own x y z
        std::array<bool, 2> moves;  ///< whether it moves the tip of each hand
        std::array<bool, 2> moves_grip;
    };
    void iterate(const ArmTargets& targets, Posture& posture, Placement& placement);

    static constexpr int kTasks = 8;
    const Skeleton& skeleton_;
    InverseKinematicsOptions options_;
    std::vector<Column> columns_;
    std::array<int, 2> stick_;
    Eigen::Matrix<double, kTasks, Eigen::Dynamic> jacobian_;
    Eigen::VectorXd pull_, step_;
};

}  // namespace percussionist::body
