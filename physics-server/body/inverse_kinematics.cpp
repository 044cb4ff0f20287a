#include "body/inverse_kinematics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "body/learnt_inverse.hpp"

namespace percussionist::body {

namespace {

/// Of a tip in one iteration [m].
constexpr double kLongestStep = 0.10;
/// Of the pull to rest where the Jacobian's transpose is used, a share.
constexpr double kTransposePull = 0.3;
/// A learnt step need not come nearer than this [m].
constexpr double kGoodEnough = 0.0005;
/// Of tips reached by hands alone: iterations, and the damping, for a stick cannot be drawn along
/// itself [m].
constexpr int kReaching = 2;
constexpr double kHandDamping = 0.015;
constexpr double kLargestReach = 0.3;  // of a wrist in an iteration [rad]

}  // namespace

// The wrist and the fingers bend before the elbow, the forearm twists little, the trunk hardly
// moves.
Vector3 InverseKinematics::usual_readiness(const Segment& s) {
    if (s.joint.ends_with("shoulder")) return {0.5, 0.6, 0.3};
    if (s.joint.ends_with("elbow")) return {0.3, 0.8, 0.1};
    if (s.joint.ends_with("wrist")) return {0.0, 1.0, 0.4};
    if (s.joint.ends_with("grip")) return {0.0, 1.0, 0.2};
    return Vector3::Constant(s.reach);
}

InverseKinematics::InverseKinematics(const Skeleton& skeleton, InverseKinematicsOptions options)
    : skeleton_(skeleton), options_(options), rest_(skeleton), before_(skeleton) {
    for (const Hand hand : kHands) stick_[static_cast<int>(hand)] = skeleton.stick_index(hand);
    for (int i = 1; i < skeleton.size(); ++i) {
        if (skeleton.segments[i].reach <= 0.0) continue;
        Column c{i, usual_readiness(skeleton.segments[i]), {}, {}};
        const std::string& joint = skeleton.segments[i].joint;
        c.of_hand = joint.ends_with("wrist") || joint.ends_with("grip");
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
    set_inverse(options.inverse);
}

InverseKinematics::~InverseKinematics() = default;

void InverseKinematics::set_inverse(Inverse inverse) {
    options_.inverse = inverse;
    learnt_.reset();
    if (inverse == Inverse::learnt) learnt_ = std::make_unique<LearntInverse>(*this);
}

void InverseKinematics::set_rest(const Posture& rest) {
    rest_ = rest;
    set_inverse(options_.inverse);
}

void InverseKinematics::set_readiness(int segment, const Vector3& weight) {
    for (Column& c : columns_) {
        if (c.segment == segment) c.weight = weight;
    }
}

std::vector<int> InverseKinematics::arms() const {
    std::vector<int> segments;
    for (const Column& c : columns_) {
        if (!c.of_hand) segments.push_back(c.segment);
    }
    return segments;
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

InverseKinematics::Tasks InverseKinematics::tasks(const Placement& placement) const {
    Tasks all;
    for (const Hand hand : kHands) {
        const int h = static_cast<int>(hand);
        all.segment<3>(4 * h) = placement.tip(skeleton_, hand);
        all[4 * h + 3] = options_.grip_weight * grip(placement, hand).z();
    }
    return all;
}

InverseKinematics::Tasks InverseKinematics::errors(const ArmTargets& targets,
                                                   const Placement& placement) const {
    Tasks error;
    for (const Hand hand : kHands) {
        const int h = static_cast<int>(hand);
        error.segment<3>(4 * h) = targets[h].tip - placement.tip(skeleton_, hand);
        error[4 * h + 3] =
            options_.grip_weight * (targets[h].grip_height - grip(placement, hand).z());
    }
    // A Jacobian tells nothing of what is far: distant targets are approached in steps.
    for (int h = 0; h < 2; ++h) {
        const double length = error.segment<4>(4 * h).norm();
        if (length > kLongestStep) error.segment<4>(4 * h) *= kLongestStep / length;
    }
    return error;
}

void InverseKinematics::fill_jacobian(const Placement& placement) {
    std::array<Vector3, 2> tips, grips;
    for (const Hand hand : kHands) {
        tips[static_cast<int>(hand)] = placement.tip(skeleton_, hand);
        grips[static_cast<int>(hand)] = grip(placement, hand);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& c = columns_[k];
        const Matrix3 axes = placement.orientation[c.segment].toRotationMatrix();
        const Vector3 origin = placement.joint[c.segment];
        for (int a = 0; a < 3; ++a) {
            const auto column = static_cast<Eigen::Index>(3 * k) + a;
            for (int h = 0; h < 2; ++h) {
                if (!c.moves[h]) continue;
                jacobian_.block<3, 1>(4 * h, column) = axes.col(a).cross(tips[h] - origin);
                if (!c.moves_grip[h]) continue;
                jacobian_(4 * h + 3, column) =
                    options_.grip_weight * axes.col(a).cross(grips[h] - origin).z();
            }
        }
    }
}

void InverseKinematics::fill_pull(const Posture& posture) {
    // The transpose does not quite undo what the pull does to the tips.
    const bool transpose = options_.inverse == Inverse::transpose;
    const double pull = (transpose ? kTransposePull : 1.0) * options_.rest_pull;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& c = columns_[k];
        const Vector3 away =
            linear::quaternion_log(rest_.joints[c.segment].conjugate() * posture.joints[c.segment]);
        for (int a = 0; a < 3; ++a) {
            const auto column = static_cast<Eigen::Index>(3 * k) + a;
            pull_[column] = c.weight[a] > 0.0 ? -pull * away[a] : 0.0;
        }
    }
}

void InverseKinematics::step(const Tasks& error, const Placement& placement, double arms) {
    Tasks wanted = error;
    wanted.noalias() -= jacobian_ * pull_;
    if (options_.inverse == Inverse::learnt) {
        learnt_->step(tasks(placement), wanted, step_);
        return;
    }
    Gram moved = gram(arms);
    if (options_.inverse == Inverse::damped_least_squares) {
        moved.diagonal().array() += options_.damping * options_.damping;
        wanted = moved.llt().solve(wanted).eval();
    } else {
        const Tasks along = moved * wanted;
        constexpr double kNothing = 1e-18;
        wanted *= wanted.dot(along) / std::max(along.squaredNorm(), kNothing);
    }
    spread(wanted, arms);
}

InverseKinematics::Gram InverseKinematics::gram(double arms) const {
    Gram sum = Gram::Zero();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const double share = columns_[k].of_hand ? 1.0 : arms;
        for (int a = 0; a < 3; ++a) {
            const double w = share * columns_[k].weight[a];
            if (w <= 0.0) continue;
            const auto column = jacobian_.col(static_cast<Eigen::Index>(3 * k) + a);
            sum.noalias() += (w * w) * column * column.transpose();
        }
    }
    return sum;
}

void InverseKinematics::spread(const Tasks& forces, double arms) {
    step_.noalias() = jacobian_.transpose() * forces;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const double share = columns_[k].of_hand ? 1.0 : arms;
        auto three = step_.segment<3>(static_cast<Eigen::Index>(3 * k));
        three = (share * columns_[k].weight).cwiseAbs2().cwiseProduct(three).eval();
    }
}

void InverseKinematics::reach_by_hands(const ArmTargets& targets, Posture& posture,
                                       Placement& placement) {
    forward_kinematics(skeleton_, posture, placement);
    pull_.setZero();
    for (int i = 0; i < kReaching; ++i) {
        fill_jacobian(placement);
        Tasks error = errors(targets, placement);
        // Where the grips are is the arms' affair.
        for (const int height : {3, 7}) {
            error[height] = 0.0;
            jacobian_.row(height).setZero();
        }
        Gram moved = gram(0.0);
        moved.diagonal().array() += kHandDamping * kHandDamping;
        spread(moved.llt().solve(error), 0.0);
        turn(posture, kLargestReach);
        forward_kinematics(skeleton_, posture, placement);
    }
}

void InverseKinematics::turn(Posture& posture, double largest) const {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& c = columns_[k];
        const auto first = static_cast<Eigen::Index>(3 * k);
        Vector3 by = step_.segment<3>(first) + pull_.segment<3>(first);
        const double angle = by.norm();
        if (angle > largest) by *= largest / angle;
        Quaternion& joint = posture.joints[c.segment];
        joint = (joint * linear::quaternion_exp(by)).normalized();
        joint = clamp(joint, skeleton_.segments[c.segment].limits);
    }
}

void InverseKinematics::iterate(const ArmTargets& targets, Posture& posture, Placement& placement) {
    fill_jacobian(placement);
    fill_pull(posture);
    const Tasks error = errors(targets, placement);
    // The transpose goes along the readiest directions alone; unequal ones it hardly follows.
    const bool transpose = options_.inverse == Inverse::transpose;
    step(error, placement, transpose ? 1.0 : options_.arms);
    if (options_.inverse != Inverse::learnt) {
        turn(posture, options_.largest_turn);
        forward_kinematics(skeleton_, posture, placement);
        return;
    }
    // What was learnt may be wrong here: a step that leads away is tried again, smaller.
    constexpr int kTries = 3;
    constexpr double kSmaller = 0.3;
    before_ = posture;
    for (int i = 0; i < kTries; ++i) {
        turn(posture, options_.largest_turn);
        forward_kinematics(skeleton_, posture, placement);
        if (errors(targets, placement).norm() <= std::max(error.norm(), kGoodEnough)) return;
        posture = before_;
        step_ *= kSmaller;
    }
    forward_kinematics(skeleton_, posture, placement);
}

void InverseKinematics::lean(const Tasks& wish, const Placement& placement, const Posture& posture,
                             Posture& target) {
    fill_jacobian(placement);
    pull_.setZero();
    step(wish, placement, 1.0);
    target = posture;
    turn(target, options_.largest_turn);
}

}  // namespace percussionist::body
