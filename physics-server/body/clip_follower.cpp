#include "body/clip_follower.hpp"

#include <cmath>

#include "body/stroke_path.hpp"

namespace percussionist::body {

namespace {

/// How slowly the hand answers its tip: hands swing below this [Hz].
constexpr double kHandFrequency = 6.0;

/// A first-order smoothing there and back, which delays nothing.
void smooth(std::vector<double>& values, double dt) {
    const double share = 1.0 - std::exp(-2.0 * 3.14159265358979 * kHandFrequency * dt);
    const auto pass = [share](auto begin, auto end) {
        double level = *begin;
        for (auto it = begin; it != end; ++it) *it = level += share * (*it - level);
    };
    pass(values.begin(), values.end());
    pass(values.rbegin(), values.rend());
}

}  // namespace

ClipFollower::ClipFollower(std::shared_ptr<const Clip> clip, const Skeleton& skeleton)
    : clip_(std::move(clip)), skeleton_(skeleton), posture_(skeleton), placement_(skeleton) {
    if (clip_->has_own_tips()) {
        fill_grip_heights();
    } else {
        habit_.emplace(skeleton, *clip_);
    }
}

void ClipFollower::fill_grip_heights() {
    const std::vector<double>& times = clip_->times();
    std::array<std::vector<double>, 2> heights;
    for (const double t : times) {
        posture(t, posture_, placement_);
        for (const Hand hand : {Hand::left, Hand::right}) {
            heights[static_cast<int>(hand)].push_back(tip(t, hand, placement_).z());
        }
    }
    forward_kinematics(skeleton_, clip_->mean(), placement_);
    std::vector<double> values(2 * times.size());
    const double dt = times.size() > 1 ? times[1] - times[0] : 1.0;
    for (const Hand hand : {Hand::left, Hand::right}) {
        const int h = static_cast<int>(hand);
        double mean = 0.0;
        for (const double z : heights[h]) mean += z / static_cast<double>(times.size());
        smooth(heights[h], dt);
        const double grip = placement_.joint[skeleton_.stick_index(hand)].z();
        for (std::size_t i = 0; i < times.size(); ++i) {
            values[2 * i + static_cast<std::size_t>(h)] =
                grip + kHandShare * (heights[h][i] - mean);
        }
    }
    grip_heights_ = Spline(times, std::move(values), 2);
}

void ClipFollower::posture(double t, Posture& posture, Placement& placement) const {
    clip_->posture(t, posture);
    forward_kinematics(skeleton_, posture, placement);
}

Vector3 ClipFollower::tip(double t, Hand hand, const Placement& placement) const {
    return clip_->has_own_tips() ? clip_->own_tip(t, hand) : placement.tip(skeleton_, hand);
}

ArmTargets ClipFollower::targets(double t, Posture& rest) const {
    if (!clip_->has_own_tips()) posture(t, posture_, placement_);
    ArmTargets targets;
    PostureHabit::Tips tips;
    for (int h = 0; h < 2; ++h) {
        tips[h] = targets[h].tip = tip(t, static_cast<Hand>(h), placement_);
    }
    std::array<double, 2> heights{};
    if (habit_) {
        habit_->posture(tips, rest);
        forward_kinematics(skeleton_, rest, placement_);
        for (int h = 0; h < 2; ++h) {
            heights[h] = placement_.joint[skeleton_.stick_index(static_cast<Hand>(h))].z();
        }
    } else {
        rest = clip_->mean();
        grip_heights_.at(std::min(std::max(t, 0.0), clip_->duration()), heights);
    }
    for (int h = 0; h < 2; ++h) targets[h].grip_height = heights[h];
    return targets;
}

}  // namespace percussionist::body
