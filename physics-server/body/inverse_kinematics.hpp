// Inverse kinematics: from the places of both stick tips to joint targets.
//
// Each arm has two tasks: its tip's place (x y z) and, softer, the height of its grip, so that the
// stick swings about a hand that moves smoothly. With the Jacobian J of the tasks, a diagonal W
// that says how readily each joint moves, and a pull z towards a rest posture, a step is
//     dq = A (e - J z) + z
// where A, which turns a wish of the tips into one of the joints, is by choice
//     damped least squares    W J^T (J W J^T + lambda^2)^-1          (Wampler 1986)
//     Jacobian transpose      alpha W J^T, alpha = e g / g g, g = J W J^T e   (Buss 2004)
//     learnt                  from the body's own babbling, see learnt_inverse.hpp
// The pull is projected as in Siciliano and Slotine 1991. A few iterations from the last solution
// follow a moving target; joint limits clamp the result.
//
// One instance a body, one thread. solve() and lean() allocate nothing; deterministic. All may be
// set between two solves; learning takes some 50 ms.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "body/posture.hpp"

namespace percussionist::body {

class LearntInverse;

struct ArmTarget {
    Vector3 tip = Vector3::Zero();  ///< middle of the stick's tip, world [m]
    double grip_height = 0.0;       ///< of the grip, world [m]
};
using ArmTargets = std::array<ArmTarget, 2>;  ///< by Hand

enum class Inverse { damped_least_squares, transpose, learnt };

struct InverseKinematicsOptions {
    Inverse inverse = Inverse::damped_least_squares;
    int iterations = 3;
    double damping = 0.002;     ///< lambda, of the tip tasks [m]
    double grip_weight = 0.3;   ///< of the grip's height against the tip's place
    double rest_pull = 0.006;   ///< share of the way to rest, each iteration
    double largest_turn = 0.3;  ///< of a joint in one iteration [rad]
    /// An arm is heavy: it is this much less ready than a hand, which so does what is fast.
    double arms = 0.3;
};

class InverseKinematics {
  public:
    static constexpr int kTasks = 8;  ///< x y z of the tip and z of the grip, left, right
    using Tasks = Eigen::Matrix<double, kTasks, 1>;
    using Jacobian = Eigen::Matrix<double, kTasks, Eigen::Dynamic>;

    /// A joint that it may turn.
    struct Column {
        int segment;
        Vector3 weight;             ///< readiness of rotation about its own x y z, 0..1
        std::array<bool, 2> moves;  ///< whether it moves the tip of each hand
        std::array<bool, 2> moves_grip;
        bool of_hand = false;  ///< wrist or grip
    };

    explicit InverseKinematics(const Skeleton& skeleton, InverseKinematicsOptions options = {});
    ~InverseKinematics();
    InverseKinematics(const InverseKinematics&) = delete;
    InverseKinematics& operator=(const InverseKinematics&) = delete;

    void set_inverse(Inverse inverse);
    /// The posture to be pulled to; the joints it does not turn are to be there.
    void set_rest(const Posture& rest);
    [[nodiscard]] const Posture& rest() const { return rest_; }
    /// The same from step to step; what the learnt inverse was learnt about stays.
    void pull_to(const Posture& rest) { rest_ = rest; }
    /// See the options.
    void set_rest_pull(double share) { options_.rest_pull = share; }
    /// See the options; a larger damping passes postures in which an arm is stretched more calmly.
    void set_damping(double damping) { options_.damping = damping; }
    void set_arms(double share) { options_.arms = share; }
    void set_largest_turn(double angle) { options_.largest_turn = angle; }
    /// How readily each axis of a joint turns, as percussionists do.
    static Vector3 usual_readiness(const Segment& segment);
    /// How readily the joint of a segment turns about its own axes, 0..1.
    void set_readiness(int segment, const Vector3& weight);

    /// Moves `posture` (from the last solution) towards the targets; returns the larger of the two
    /// tips' remaining errors [m]. `placement` is that of the new posture.
    double solve(const ArmTargets& targets, Posture& posture, Placement& placement);

    /// Brings the tips as near as wrists and fingers alone can, from where the arms are.
    void reach_by_hands(const ArmTargets& targets, Posture& posture, Placement& placement);

    /// From where the tasks are to where they are wanted.
    [[nodiscard]] Tasks errors(const ArmTargets& targets, const Placement& placement) const;
    /// `target` is `posture` with its tasks moved by `wish`, by the Jacobian where the body is
    /// (`placement`): target = posture + A wish.
    void lean(const Tasks& wish, const Placement& placement, const Posture& posture,
              Posture& target);

    /// Where the grip is, world [m].
    [[nodiscard]] Vector3 grip(const Placement& placement, Hand hand) const;

    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
    /// The segments whose joints it turns, but hands and sticks.
    [[nodiscard]] std::vector<int> arms() const;
    [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
    /// Where the tasks are: tips, and grips' heights times their weight.
    [[nodiscard]] Tasks tasks(const Placement& placement) const;

  private:
    void fill_jacobian(const Placement& placement);
    void fill_pull(const Posture& posture);
    /// `arms`: how ready they are against hands; 0: hands alone.
    void step(const Tasks& error, const Placement& placement, double arms);
    /// J W J^T.
    using Gram = Eigen::Matrix<double, kTasks, kTasks>;
    [[nodiscard]] Gram gram(double arms) const;
    /// step_ = W J^T forces.
    void spread(const Tasks& forces, double arms);
    void turn(Posture& posture, double largest) const;
    void iterate(const ArmTargets& targets, Posture& posture, Placement& placement);

    const Skeleton& skeleton_;
    InverseKinematicsOptions options_;
    std::vector<Column> columns_;
    std::array<int, 2> stick_;
    Posture rest_, before_;
    Jacobian jacobian_;
    Eigen::VectorXd pull_, step_;
    std::unique_ptr<LearntInverse> learnt_;
};

}  // namespace percussionist::body
