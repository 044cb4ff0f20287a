#include "body/inverse_kinematics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace percussionist::body {

namespace {

constexpr std::array<Hand, 2> kHands{Hand::left, Hand::right};

/// How readily each axis of a joint turns, out of what percussionists do: the wrist and the fingers
/// bend before the elbow, the forearm twists little, the trunk hardly moves.
Vector3 readiness(const Segment& s) {
    if (s.joint.ends_with("shoulder")) return {0.5, 0.6, 0.3};
    if (s.joint.ends_with("elbow")) return {0.3, 0.8, 0.1};
    if (s.joint.ends_with("wrist")) return {0.0, 1.0, 0.4};
    if (s.joint.ends_with("grip")) return {0.0, 1.0, 0.2};
    return Vector3::Constant(s.reach);
}

}  // namespace

InverseKinematics::InverseKinematics(const Skeleton& skeleton, InverseKinematicsOptions options)
    : skeleton_(skeleton), options_(options) {
    for (const Hand hand : kHands) stick_[static_cast<int>(hand)] = skeleton.stick_index(hand);
    for (int i = 1; i < skeleton.size(); ++i) {
        if (skeleton.segments[i].reach <= 0.0) continue;
        Column c{i, readiness(skeleton.segments[i]), {}, {}};
        for (int h = 0; h < 2; ++h) {
            c.moves[h] = skeleton.moves(i, stick_[h]);
            c.moves_grip[h] = c.moves[h] && i != stick_[h];
        }
        columns_.push_back(c);
    }
    const auto count = 3 * static_cast<Eigen::Index>(columns_.size());
    jacobian_.setZero(kTasks, count);
    pull_.setZero(count);
    step_.setZero(count);
}

Vector3 InverseKinematics::grip(const Placement& placement, Hand hand) const {
    return placement.joint[stick_[static_cast<int>(hand)]];
}

double InverseKinematics::solve(const ArmTargets& targets, Posture& posture, Placement& placement) {
    forward_kinematics(skeleton_, posture, placement);
    for (int i = 0; i < options_.iterations; ++i) iterate(targets, posture, placement);
    double worst = 0.0;
    for (const Hand hand : kHands) {
        const Vector3& wanted = targets[static_cast<int>(hand)].tip;
        worst = std::max(worst, (placement.tip(skeleton_, hand) - wanted).norm());
    }
    return worst;
}

void InverseKinematics::iterate(const ArmTargets& targets, Posture& posture, Placement& placement) {
    Eigen::Matrix<double, kTasks, 1> error;
    std::array<Vector3, 2> tips, grips;
    for (const Hand hand : kHands) {
        const int h = static_cast<int>(hand);
        tips[h] = placement.tip(skeleton_, hand);
        grips[h] = grip(placement, hand);
        error.segment<3>(4 * h) = targets[h].tip - tips[h];
        error[4 * h + 3] = options_.grip_weight * (targets[h].grip_height - grips[h].z());
    }

    // Columns are scaled by the weights: J W^1/2 with the step scaled back, and the pull likewise.
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& c = columns_[k];
        const Matrix3 axes = placement.orientation[c.segment].toRotationMatrix();
        const Vector3 away = linear::quaternion_log(posture.joints[c.segment]);
        for (int a = 0; a < 3; ++a) {
            const auto column = static_cast<Eigen::Index>(3 * k) + a;
            pull_[column] = c.weight[a] > 0.0 ? -options_.rest_pull * away[a] : 0.0;
            for (int h = 0; h < 2; ++h) {
                if (!c.moves[h]) continue;
                const Vector3 origin = placement.joint[c.segment];
                jacobian_.block<3, 1>(4 * h, column) = axes.col(a).cross(tips[h] - origin);
                if (c.moves_grip[h]) {
                    jacobian_(4 * h + 3, column) =
                        options_.grip_weight * axes.col(a).cross(grips[h] - origin).z();
                }
            }
        }
    }
    Eigen::Matrix<double, kTasks, kTasks> gram =
        options_.damping * options_.damping * Eigen::Matrix<double, kTasks, kTasks>::Identity();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        for (int a = 0; a < 3; ++a) {
            const double w = columns_[k].weight[a];
            if (w <= 0.0) continue;
            const auto column = jacobian_.col(static_cast<Eigen::Index>(3 * k) + a);
            gram.noalias() += (w * w) * column * column.transpose();
        }
    }
    Eigen::Matrix<double, kTasks, 1> pulled = error;
    pulled.noalias() -= jacobian_ * pull_;
    const Eigen::Matrix<double, kTasks, 1> y = gram.llt().solve(pulled);
    step_.noalias() = jacobian_.transpose() * y;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& c = columns_[k];
        const auto first = static_cast<Eigen::Index>(3 * k);
        const Vector3 turn =
            c.weight.cwiseAbs2().cwiseProduct(step_.segment<3>(first)) + pull_.segment<3>(first);
        Quaternion& joint = posture.joints[c.segment];
        joint = (joint * linear::quaternion_exp(turn)).normalized();
        joint = clamp(joint, skeleton_.segments[c.segment].limits);
    }
    forward_kinematics(skeleton_, posture, placement);
}

}  // namespace percussionist::body
