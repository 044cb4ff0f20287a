#include "body/learnt_inverse.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace percussionist::body {

namespace {

constexpr int kPostures = 48;
constexpr int kBabbles = 160;
constexpr double kSpread = 0.5;   ///< of the postures about rest, of a joint that is ready [rad]
constexpr double kBabble = 0.02;  ///< [rad]
constexpr double kRidge = 2e-6;   ///< against directions in which nothing moved [m^2]
constexpr double kNear = 0.12;    ///< width of the kernel [m]
/// A map that is not quite right is trusted with so much of the way.
constexpr double kTrust = 0.8;

Vector3 random_turn(std::mt19937& random, const Vector3& weight, double size) {
    const auto one = [&] { return 2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0; };
    const double x = one();
    const double y = one();
    return size * weight.cwiseProduct(Vector3(x, y, one()));
}

}  // namespace

LearntInverse::LearntInverse(const InverseKinematics& kinematics) {
    std::mt19937 random(1);
    for (int p = 0; p < kPostures; ++p) {
        Posture posture = kinematics.rest();
        for (const auto& c : kinematics.columns()) {
            const double spread = p == 0 ? 0.0 : kSpread;
            const Vector3 by = random_turn(random, c.weight, spread);
            Quaternion& joint = posture.joints[c.segment];
            joint = clamp((joint * linear::quaternion_exp(by)).normalized(),
                          kinematics.skeleton().segments[c.segment].limits);
        }
        learn_about(kinematics, posture, random);
    }
}

void LearntInverse::learn_about(const InverseKinematics& kinematics, const Posture& posture,
                                std::mt19937& random) {
    const auto& columns = kinematics.columns();
    const auto count = 3 * static_cast<Eigen::Index>(columns.size());
    Placement placement(kinematics.skeleton());
    forward_kinematics(kinematics.skeleton(), posture, placement);
    const InverseKinematics::Tasks at = kinematics.tasks(placement);

    Map both[2] = {Map::Zero(count, 4), Map::Zero(count, 4)};
    Eigen::Matrix4d moved[2] = {kRidge * Eigen::Matrix4d::Identity(),
                                kRidge * Eigen::Matrix4d::Identity()};
    Eigen::VectorXd turns(count);
    for (int b = 0; b < kBabbles; ++b) {
        Posture babbled = posture;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const Vector3 by = random_turn(random, columns[k].weight, kBabble);
            turns.segment<3>(static_cast<Eigen::Index>(3 * k)) = by;
            Quaternion& joint = babbled.joints[columns[k].segment];
            joint = joint * linear::quaternion_exp(by);
        }
        forward_kinematics(kinematics.skeleton(), babbled, placement);
        const InverseKinematics::Tasks change = kinematics.tasks(placement) - at;
        for (int h = 0; h < 2; ++h) {
            const Eigen::Vector4d x = change.segment<4>(4 * h);
            both[h] += turns * x.transpose();
            moved[h] += x * x.transpose();
        }
    }
    for (int h = 0; h < 2; ++h) {
        Map map = both[h] * moved[h].inverse();
        // An arm has learnt nothing of joints that do not move it but chance.
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (!columns[k].moves[h]) map.middleRows(static_cast<Eigen::Index>(3 * k), 3).setZero();
        }
        lessons_[h].push_back({at.segment<4>(4 * h), map});
    }
}

void LearntInverse::step(const InverseKinematics::Tasks& at, const InverseKinematics::Tasks& wanted,
                         Eigen::VectorXd& turns) const {
    turns.setZero();
    for (int h = 0; h < 2; ++h) {
        const Eigen::Vector4d x = kTrust * wanted.segment<4>(4 * h);
        const auto nearness = [&](const Lesson& lesson, double least) {
            const double distance2 = (lesson.at - at.segment<4>(4 * h)).squaredNorm();
            return std::exp((least - distance2) / (2.0 * kNear * kNear));
        };
        // Counted from the nearest, so that far from all of them it still is that one.
        double least = 1e9;
        for (const Lesson& lesson : lessons_[h]) {
            least = std::min(least, (lesson.at - at.segment<4>(4 * h)).squaredNorm());
        }
        double sum = 0.0;
        for (const Lesson& lesson : lessons_[h]) sum += nearness(lesson, least);
        for (const Lesson& lesson : lessons_[h]) {
            const double share = nearness(lesson, least) / sum;
            constexpr double kNothing = 1e-4;
            if (share < kNothing) continue;
            turns.noalias() += lesson.map * (share * x);
        }
    }
}

}  // namespace percussionist::body
