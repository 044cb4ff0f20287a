#include "body/joint_strength.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::body {

namespace {

Vector3 turn(const Quaternion& from, const Quaternion& to) {
    return linear::quaternion_log(to * from.conjugate());
}

}  // namespace

double hanging_inertia(const Skeleton& skeleton, int segment) {
    double inertia = 0.0;
    for (int k = segment; k < skeleton.size(); ++k) {
        if (!skeleton.moves(segment, k)) continue;
        const Segment& s = skeleton.segments[k];
        const double distance2 = (s.com_rest - skeleton.segments[segment].joint_rest).squaredNorm();
        inertia += s.mass * distance2 + s.inertia.maxCoeff();
    }
    return inertia;
}

JointStrength::JointStrength(const Skeleton& skeleton, const std::vector<int>& segments, double h)
    : asked_(skeleton), wish_(skeleton) {
    for (const int i : segments) {
        const double acceleration =
            skeleton.segments[i].torque_limit / hanging_inertia(skeleton, i);
        joints_.push_back({i, acceleration * h * h});
    }
}

bool JointStrength::hold(const Posture& before, const Posture& now, Posture& wish) {
    constexpr double kNothing = 1e-12;
    bool held = false;
    wish_ = wish;
    for (const Joint& j : joints_) {
        const Quaternion& at = now.joints[j.segment];
        const Vector3 last = turn(before.joints[j.segment], at);
        const Vector3 off = turn(at, asked_.joints[j.segment]);
        const double distance = off.norm();
        const double closing = std::min(distance, std::sqrt(j.most * distance));
        Vector3 next = turn(asked_.joints[j.segment], wish.joints[j.segment]);
        if (distance > kNothing) next += closing / distance * off;
        Vector3 change = next - last;
        const double size = change.norm();
        if (size <= j.most && closing == distance) continue;
        if (size > j.most) change *= j.most / size;
        wish.joints[j.segment] = (linear::quaternion_exp(last + change) * at).normalized();
        held = true;
    }
    std::swap(asked_, wish_);
    return held;
}

}  // namespace percussionist::body
