#include "body/kit_animation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percussionist::body {

namespace {

using score::KitStroke;
using score::Limb;

constexpr double kLookAhead = 0.25;    // [s]
constexpr double kLookApart = 0.5;     // [s]
constexpr double kLookShare = 0.45;    // of the way that the eyes do not make
constexpr double kFarthestLook = 0.5;  // [rad]
constexpr double kLookDown = 0.30;     // [rad]

std::vector<KitStroke> of_limb(std::span<const KitStroke> strokes, Limb limb) {
    std::vector<KitStroke> own;
    std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(own),
                 [limb](const KitStroke& s) { return s.limb == limb; });
    return own;
}

bool plays_hat(const score::Kit& kit, Limb foot) {
    const score::Pedal* const pedal = kit.pedal_of(foot);
    return pedal != nullptr && kit.objects[pedal->object].kind == score::ObjectKind::hi_hat;
}

}  // namespace

KitAnimation::KitAnimation(const score::Kit& kit, std::span<const KitStroke> strokes)
    : kit_(kit),
      strokes_(strokes.begin(), strokes.end()),
      skeleton_(make_drummer(kit.drummer)),
      poses_(skeleton_, kit),
      kit_motion_(kit, strokes),
      head_(skeleton_.index("head")) {
    for (const KitStroke& s : strokes_) {
        if (s.event >= kit.events.size() || !poses_.of(s.limb, s.event)) {
            throw std::invalid_argument("animation: a stroke that its limb does not play");
        }
    }
    lay();
    look_about();
}

void KitAnimation::lay() {
    limbs_.clear();
    for (const Limb limb : {Limb::left_hand, Limb::right_hand, Limb::left_foot, Limb::right_foot}) {
        std::vector<KeyFrame> keys = !score::is_hand(limb) && plays_hat(kit_, limb)
                                         ? hat_key_frames(poses_, kit_, limb, strokes_)
                                         : key_frames(poses_, kit_, limb, of_limb(strokes_, limb));
        limbs_.emplace_back(skeleton_, kit_, poses_.parts(limb), std::move(keys));
    }
}

void KitAnimation::edit(const score::PoseEdit& pose) {
    poses_.edit(pose);
    lay();
}

void KitAnimation::look_about() {
    for (const KitStroke& s : strokes_) {
        if (!score::is_hand(s.limb)) continue;
        const double time = s.time - kLookAhead;
        if (!looks_.empty() && time - looks_.back().time < kLookApart) continue;
        const Vector3 spot = spot_of(kit_, s.event, s.limb);
        const double to = kLookShare * std::atan2(spot.y(), spot.x());
        looks_.push_back({time, std::clamp(to, -kFarthestLook, kFarthestLook)});
    }
}

double KitAnimation::azimuth(double t) const {
    const auto next = std::upper_bound(looks_.begin(), looks_.end(), t,
                                       [](double time, const Look& l) { return time < l.time; });
    if (next == looks_.begin()) return looks_.empty() ? 0.0 : next->azimuth;
    const Look& last = *(next - 1);
    if (next == looks_.end()) return last.azimuth;
    const double u = std::min(1.0, (t - last.time) / std::min(next->time - last.time, 1.0));
    return last.azimuth + u * u * (3.0 - 2.0 * u) * (next->azimuth - last.azimuth);
}

void KitAnimation::trunk_at(double t, Posture& posture) const {
    posture = poses_.seat();
    posture.joints[head_] = from_euler_zyx({azimuth(t), kLookDown, 0.0});
}

void KitAnimation::at(double t, Posture& posture, Placement& placement) const {
    trunk_at(t, posture);
    for (const LimbMotion& limb : limbs_) limb.at(t, posture);
    forward_kinematics(skeleton_, posture, placement);
}

Vector3 KitAnimation::limb_point(const Placement& placement, Limb limb, std::size_t event) const {
    if (!score::is_hand(limb)) return ball_of(skeleton_, placement, limb);
    const Hand hand = limb == Limb::left_hand ? Hand::left : Hand::right;
    return placement.tip(skeleton_, hand) -
           skeleton_.stick.tip_radius * kit_.object_of(event).normal();
}

Vector3 KitAnimation::target(Limb limb, std::size_t event) const {
    if (score::is_hand(limb)) return spot_of(kit_, event, limb);
    return plate_point(*kit_.pedal_of(limb), 0.0);
}

}  // namespace percussionist::body
