#include "sim/stick_tip.hpp"

#include <algorithm>

namespace percussionist::sim {

StickTip::StickTip(const body::Skeleton& skeleton, body::Hand hand)
    : hand_(hand),
      radius_(skeleton.stick.tip_radius),
      mass_(skeleton, hand),
      bare_(skeleton.segments.size(), 0.0) {}

void StickTip::look(const OdeBody& body) {
    before_ = velocity_;
    position_ = body.tip_position(hand_);
    velocity_ = body.tip_velocity(hand_);
}

TouchingTip StickTip::against(const Face& face, const Drumhead& head, const body::Placement& actual,
                              const std::vector<double>& resistance, double h) {
    const Quaternion to_face = face.turn.conjugate();
    const Vector3 arm = position_ - face.middle;
    TouchingTip t;
    t.place = to_face * arm;
    t.place.z() -= radius_;
    t.velocity = to_face * (velocity_ - face.velocity - face.spin.cross(arm));
    if (!head.near(t)) return t;
    const Vector3 normal = face.normal();
    t.mass = mass_(actual, normal, resistance);
    t.bare_mass = bare_mass(actual, normal);
    // What moves the tip besides what it strikes: its last change of velocity less that part.
    constexpr double kMost = 200.0;
    const double change = normal.dot(velocity_ - before_) - normal.dot(impulse_) / t.mass;
    t.acceleration = std::clamp(change / h, -kMost, kMost);
    return t;
}

}  // namespace percussionist::sim
