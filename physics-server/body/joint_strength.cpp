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
    : asked_(skeleton), before_(skeleton), now_(skeleton) {
    for (const int i : segments) {
        const double acceleration =
            skeleton.segments[i].torque_limit / hanging_inertia(skeleton, i);
        joints_.push_back({i, acceleration * h * h});
    }
}

void JointStrength::begin(const Posture& before, const Posture& now) {
    before_ = before;
    now_ = asked_ = now;
}

bool JointStrength::hold(Posture& wish) {
    constexpr double kNothing = 1e-12;
    bool held = false;
    for (const Joint& j : joints_) {
        const Quaternion at = now_.joints[j.segment];
        const Vector3 last = turn(before_.joints[j.segment], at);
        const Vector3 off = turn(at, asked_.joints[j.segment]);
        const double distance = off.norm();
        const double closing = std::min(distance, std::sqrt(j.most * distance));
        Quaternion& wanted = wish.joints[j.segment];
        Vector3 next = turn(asked_.joints[j.segment], wanted);
        asked_.joints[j.segment] = wanted;
        if (distance > kNothing) next += closing / distance * off;
        Vector3 change = next - last;
        const double size = change.norm();
        if (size > j.most || closing < distance) {
            if (size > j.most) change *= j.most / size;
            wanted = (linear::quaternion_exp(last + change) * at).normalized();
            held = true;
        }
    }
    std::swap(before_, now_);
    now_ = wish;
    return held;
}

}  // namespace percussionist::body
