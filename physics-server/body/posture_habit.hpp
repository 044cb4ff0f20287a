// The posture that a body usually has when its tips are somewhere, learnt from its captured motion.
//
// Tips alone leave most of a posture open. Which of all postures a person takes is a habit: the
// rotation of each joint against its mean, as a vector, is a quadratic function of where both tips
// are, found by least squares with a ridge over the frames of a clip. Inverse kinematics is pulled
// there, and corrects it until the tips are where they are wanted.
//
// Learning allocates; reading is pure and real-time safe.
#pragma once

#include <Eigen/Core>

#include "body/clip.hpp"

namespace percussionist::body {

class PostureHabit {
  public:
    using Tips = std::array<Vector3, 2>;  ///< by Hand, world [m]

    /// From the clip's own postures and the tips they put there.
    PostureHabit(const Skeleton& skeleton, const Clip& clip);

    /// Of every joint; far from all that was learnt it is that at the edge.
    void posture(const Tips& tips, Posture& posture) const;

  private:
    static constexpr int kCoordinates = 6;
    static constexpr int kFeatures = 1 + kCoordinates + kCoordinates * (kCoordinates + 1) / 2;
    using Features = Eigen::Matrix<double, kFeatures, 1>;
    using Coordinates = Eigen::Matrix<double, kCoordinates, 1>;
    [[nodiscard]] Features features(const Tips& tips) const;

    Posture mean_;
    Coordinates middle_, spread_;                           ///< of the tips over the clip [m]
    Eigen::Matrix<double, Eigen::Dynamic, kFeatures> map_;  ///< three rows a joint
};

}  // namespace percussionist::body
