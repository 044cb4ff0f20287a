// Inverse kinematics that a body learns of itself, without its Jacobian.
//
// It babbles: about each of some postures it makes small random turns of its joints, d_theta, and
// sees what they do to the tasks, d_x. There the inverse is the linear map that tells the turns
// from what they did best, A = sum(d_theta d_x^T) (sum(d_x d_x^T) + ridge)^-1. In between, the maps
// are weighed by how near the tasks are to those they were learnt at, by a Gaussian kernel:
// non-parametric learning as in Gibet and Marteau 2003, "Expressive gesture animation based on non
// parametric learning of sensory-motor models". What a map gets wrong the next iteration sees and
// mends.
//
// The random numbers are always the same. Learning allocates and takes some 50 ms; step() is pure.
#pragma once

#include <random>
#include <vector>

#include "body/inverse_kinematics.hpp"

namespace percussionist::body {

class LearntInverse {
  public:
    /// Learns about the rest posture of `kinematics`, with its joints and their readiness.
    explicit LearntInverse(const InverseKinematics& kinematics);

    /// The turns (three a column) that move tasks which are at `at` by `wanted`.
    void step(const InverseKinematics::Tasks& at, const InverseKinematics::Tasks& wanted,
              Eigen::VectorXd& turns) const;

  private:
    using Map = Eigen::Matrix<double, Eigen::Dynamic, 4>;
    /// What one arm's tasks (tip, grip's height) took to move, about one posture.
    struct Lesson {
        Eigen::Vector4d at;
        Map map;
    };
    void learn_about(const InverseKinematics& kinematics, const Posture& posture,
                     std::mt19937& random);

    std::vector<Lesson> lessons_[2];  ///< by Hand
};

}  // namespace percussionist::body
