#include "body/animation_check.hpp"

#include <cmath>

namespace percussionist::body {

StrokeCheck check_stroke(const KitAnimation& animation, const score::KitStroke& stroke) {
    constexpr double kStep = 1e-4;     // [s]
    constexpr double kThere = 0.0001;  // [m]
    constexpr int kMostSteps = 300;
    Posture posture(animation.skeleton());
    Placement placement(animation.skeleton());
    const Vector3 target = animation.target(stroke.limb, stroke.event);
    const auto off_at = [&](double t) {
        animation.at(t, posture, placement);
        return (animation.limb_point(placement, stroke.limb, stroke.event) - target).norm();
    };
    StrokeCheck check;
    check.off = off_at(stroke.time);
    int steps = 1;
    while (steps < kMostSteps && off_at(stroke.time - steps * kStep) < kThere) ++steps;
    check.early = (steps - 1) * kStep;
    return check;
}

StickWatch::StickWatch(const KitAnimation& animation, const score::Kit& kit)
    : animation_(animation), kit_(kit) {}

void StickWatch::see(double time, const Placement& placement) {
    for (const Hand hand : {Hand::left, Hand::right}) {
        const Vector3 tip = placement.tip(animation_.skeleton(), hand);
        Vector3& last = last_[static_cast<int>(hand)];
        if (!first_) {
            const double speed = (tip - last).norm() / (time - last_time_);
            look_below(time, hand, last, tip);
            if (speed > top_speed_) {
                top_speed_ = speed;
                fast_at_ = time;
            }
        }
        last = tip;
    }
    last_time_ = time;
    first_ = false;
}

void StickWatch::look_below(double time, Hand hand, const Vector3& before, const Vector3& now) {
    constexpr double kDepth = -0.005;  // [m]
    for (std::size_t o = 0; o < kit_.objects.size(); ++o) {
        const score::KitObject& object = kit_.objects[o];
        const Quaternion to_face = object.orientation().conjugate();
        const double above = (to_face * (before - object.middle)).z() - kDepth;
        const Vector3 there = to_face * (now - object.middle);
        const bool inside = std::hypot(there.x(), there.y()) < object.radius;
        if (inside && above >= 0.0 && there.z() < kDepth) {
            through_.push_back({time, hand, o});
        }
    }
}

}  // namespace percussionist::body
