#include "body/live_limb.hpp"

#include <utility>

namespace percussionist::body {

LiveLimb::LiveLimb(const Skeleton& skeleton, const score::Kit& kit, const LimbParts& parts)
    : skeleton_(skeleton),
      kit_(kit),
      parts_(parts),
      residue_(parts.segments.size(), Vector3::Zero()) {}

void LiveLimb::perform(std::vector<KeyFrame> keys) {
    own_.emplace(skeleton_, kit_, parts_, std::move(keys));
}

void LiveLimb::bend(double within) {
    own_.reset();
    bends_ = !pose_.empty();
    bend_time_ = within;
}

void LiveLimb::at(double now, const LimbMotion& song, double position, Posture& posture) {
    if (own_) {
        own_->at(now, posture);
    } else {
        song.at(position, posture);
    }
    if (bends_) {
        for (std::size_t j = 0; j < residue_.size(); ++j) {
            const Quaternion& base = posture.joints[parts_.segments[j]];
            residue_[j] = linear::quaternion_log(base.conjugate() * pose_[j]);
        }
        bend_from_ = now_;
        bends_ = false;
    }
    const double u = bend_time_ > 0.0 ? (now - bend_from_) / bend_time_ : 1.0;
    const double left = own_ || u >= 1.0 ? 0.0 : 1.0 - u * u * (3.0 - 2.0 * u);
    pose_.resize(residue_.size());
    for (std::size_t j = 0; j < residue_.size(); ++j) {
        Quaternion& joint = posture.joints[parts_.segments[j]];
        if (left > 0.0) joint = joint * linear::quaternion_exp(left * residue_[j]);
        pose_[j] = joint;
    }
    now_ = now;
}

}  // namespace percussionist::body
