#include "core/motion/pose_gate.hpp"

#include <utility>

namespace percussionist::motion {

bool PoseGate::near(const TimedPose& a, const TimedPose& b) const noexcept {
    const double reach = settings_.slack + settings_.top_speed * (b.time - a.time);
    return (b.pose.position - a.pose.position).norm() <= reach;
}

PoseGate::Verdict PoseGate::judge(const TimedPose& pose) noexcept {
    if (last_ && pose.time <= last_->time) {
        ++repeats_;
        return Verdict::kRepeat;
    }
    if (!last_ || pose.time - last_->time > settings_.longest_gap) {
        suspect_.reset();
        last_ = pose;
        return Verdict::kFresh;
    }
    if (pose.pose.position == last_->pose.position &&
        pose.pose.orientation.coeffs() == last_->pose.orientation.coeffs()) {
        ++repeats_;
        return Verdict::kRepeat;
    }
    if (near(*last_, pose)) {
        suspect_.reset();
        last_ = pose;
        return Verdict::kGood;
    }
    const bool again = suspect_ && suspect_->time < pose.time && near(*suspect_, pose);
    suspect_ = pose;
    if (again) {
        last_ = std::exchange(suspect_, std::nullopt);
        return Verdict::kFresh;
    }
    ++jumps_;
    return Verdict::kJump;
}

}  // namespace percussionist::motion
