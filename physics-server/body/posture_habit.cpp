#include "body/posture_habit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace percussionist::body {

namespace {

/// Frames that are learnt from, at most.
constexpr std::size_t kMostFrames = 3000;
/// Against what few frames say by chance, a share of all of them.
constexpr double kRidge = 1e-3;
/// Coordinates are held within so many deviations of their middle, and vary by this at least [m].
constexpr double kFarthest = 3.0;
constexpr double kLeastSpread = 0.005;

Eigen::Matrix<double, 6, 1> together(const PostureHabit::Tips& tips) {
    Eigen::Matrix<double, 6, 1> both;
    both << tips[0], tips[1];
    return both;
}

}  // namespace

PostureHabit::PostureHabit(const Skeleton& skeleton, const Clip& clip) : mean_(clip.mean()) {
    const std::vector<double>& times = clip.times();
    const std::size_t stride = 1 + times.size() / kMostFrames;
    const auto rows = 3 * static_cast<Eigen::Index>(skeleton.segments.size());
    Posture posture(skeleton);
    Placement placement(skeleton);
    const auto tips_at = [&](double t) -> Tips {
        clip.posture(t, posture);
        forward_kinematics(skeleton, posture, placement);
        return {placement.tip(skeleton, Hand::left), placement.tip(skeleton, Hand::right)};
    };
    middle_.setZero();
    Coordinates squares = Coordinates::Zero();
    double count = 0.0;
    for (std::size_t i = 0; i < times.size(); i += stride, ++count) {
        const Coordinates c = together(tips_at(times[i]));
        middle_ += c;
        squares += c.cwiseAbs2();
    }
    middle_ /= count;
    spread_ = (squares / count - middle_.cwiseAbs2()).cwiseMax(kLeastSpread * kLeastSpread);
    spread_ = spread_.cwiseSqrt().eval();

    Eigen::Matrix<double, kFeatures, kFeatures> gram;
    gram.setIdentity();
    gram *= kRidge * count;
    Eigen::Matrix<double, Eigen::Dynamic, kFeatures> both;
    both.setZero(rows, kFeatures);
    Eigen::VectorXd turns(rows);
    for (std::size_t i = 0; i < times.size(); i += stride) {
        const Features f = features(tips_at(times[i]));
        for (std::size_t j = 0; j < posture.joints.size(); ++j) {
            turns.segment<3>(static_cast<Eigen::Index>(3 * j)) =
                linear::quaternion_log(mean_.joints[j].conjugate() * posture.joints[j]);
        }
        gram += f * f.transpose();
        both += turns * f.transpose();
    }
    map_ = gram.llt().solve(both.transpose()).transpose();
}

PostureHabit::Features PostureHabit::features(const Tips& tips) const {
    const Coordinates c =
        (together(tips) - middle_).cwiseQuotient(spread_).cwiseMax(-kFarthest).cwiseMin(kFarthest);
    Features f;
    f[0] = 1.0;
    f.segment<kCoordinates>(1) = c;
    int at = 1 + kCoordinates;
    for (int i = 0; i < kCoordinates; ++i) {
        for (int j = i; j < kCoordinates; ++j) f[at++] = c[i] * c[j];
    }
    return f;
}

void PostureHabit::posture(const Tips& tips, Posture& posture) const {
    const Features f = features(tips);
    for (std::size_t j = 0; j < posture.joints.size(); ++j) {
        const Vector3 turn = map_.middleRows<3>(static_cast<Eigen::Index>(3 * j)) * f;
        posture.joints[j] = (mean_.joints[j] * linear::quaternion_exp(turn)).normalized();
    }
}

}  // namespace percussionist::body
