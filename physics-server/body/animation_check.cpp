#include "body/animation_check.hpp"

#include <cmath>

namespace percussionist::body {

StrokeCheck check_stroke(const KitAnimation& animation, const score::KitStroke& stroke) {
    constexpr double kStep = 1e-4;     // [s]
    constexpr double kThere = 0.0005;  // [m]
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
            if (speed > top_speed_) {
                top_speed_ = speed;
                fast_at_ = time;
            }
        }
        last = tip;
        look_below(time, tip);
    }
    last_time_ = time;
    first_ = false;
}

void StickWatch::look_below(double time, const Vector3& tip) {
    constexpr double kFarBelow = 0.10;  // beyond this it is another thing's business [m]
    for (const score::KitObject& object : kit_.objects) {
        const Vector3 there = object.orientation().conjugate() * (tip - object.middle);
        if (std::hypot(there.x(), there.y()) > object.radius) continue;
        const double depth = animation_.skeleton().stick.tip_radius - there.z();
        if (depth > deepest_ && depth < kFarBelow) {
            deepest_ = depth;
            deep_at_ = time;
        }
    }
}

}  // namespace percussionist::body
