#include "body/drummer.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::body {

namespace {

using score::Limb;

constexpr double kLean = 0.07;        // of the back, at either joint of the spine [rad]
constexpr double kHeelBehind = 0.06;  // the ankle, along the foot [m]
constexpr double kBallBefore = 0.13;  // the ankle [m]
constexpr double kStickTip = 0.006;   // radius [m]
constexpr double kOutward = 0.25;     // of the knees, of forward

std::string side_of(Limb limb) {
    return limb == Limb::left_hand || limb == Limb::left_foot ? "left_" : "right_";
}

double shank_end_above_sole(const Skeleton& skeleton) {
    const Segment& shank = skeleton.segments[skeleton.index("left_shank")];
    const Segment& thigh = skeleton.segments[skeleton.index("left_thigh")];
    const double leg = thigh.joint_rest.z() - shank.end_rest.z();
    constexpr double kOfLeg =
        0.039 / 0.491;  // Winter 2009: the ankle's height over thigh and shank
    return kOfLeg * leg;
}

Quaternion plate_turn(const score::Pedal& pedal, double up) {
    const double angle = pedal.down + up * (pedal.up - pedal.down);
    return from_euler_zyx({pedal.direction, -angle, 0.0});
}

/// Of a foot without a pedal: on the floor, beside the other.
score::Pedal no_pedal(Limb foot) {
    score::Pedal floor;
    floor.foot = foot;
    floor.heel = {0.30, foot == Limb::left_foot ? 0.25 : -0.25, 0.0};
    floor.down = floor.up = 0.0;
    return floor;
}

/// A frame whose z runs against `along`, turned so that y is `hinge`.
Quaternion rod(const Vector3& along, const Vector3& hinge) {
    Matrix3 axes;
    axes.col(2) = -along.normalized();
    axes.col(1) = hinge;
    axes.col(0) = axes.col(1).cross(axes.col(2));
    return Quaternion(axes);
}

/// Where the knee is, between hip and ankle, on the side of `towards`.
Vector3 knee_between(const Vector3& hip, const Vector3& ankle, double thigh, double shank,
                     const Vector3& towards) {
    const Vector3 way = ankle - hip;
    const double length =
        std::clamp(way.norm(), std::abs(thigh - shank) + 1e-6, thigh + shank - 1e-6);
    const Vector3 along = way.normalized();
    const double share = (length * length + thigh * thigh - shank * shank) / (2.0 * length);
    const double out = std::sqrt(std::max(0.0, thigh * thigh - share * share));
    return hip + share * along + out * (towards - towards.dot(along) * along).normalized();
}

}  // namespace

LimbParts parts_of(const Skeleton& skeleton, Limb limb) {
    const std::string side = side_of(limb);
    LimbParts parts;
    const auto add = [&](const char* name) {
        parts.segments.push_back(skeleton.index(side + name));
    };
    if (score::is_hand(limb)) {
        for (const char* name : {"clavicle", "upper_arm", "forearm", "hand", "stick"}) add(name);
    } else {
        for (const char* name : {"thigh", "shank", "foot"}) add(name);
    }
    return parts;
}

Skeleton make_drummer(const score::Drummer& drummer) {
    Anthropometry person;
    person.stature = drummer.stature;
    person.mass = drummer.mass;
    person.stick.length = drummer.stick_length;
    person.stick.held_at = drummer.stick_held;
    person.stick.mass = drummer.stick_mass;
    person.stick.tip_radius = kStickTip;
    Lengths l = lengths_of(drummer.stature);
    const double drop = l.hip_height - drummer.hips;
    for (double* height : {&l.hip_height, &l.lumbar_height, &l.thoracic_height, &l.neck_height,
                           &l.shoulder_height}) {
        *height -= drop;
    }
    person.lengths = l;
    return make_skeleton(person);
}

double put_foot(const Skeleton& skeleton, const score::Kit& kit, Limb foot, double up,
                Posture& posture) {
    const score::Pedal* const given = kit.pedal_of(foot);
    const score::Pedal pedal = given != nullptr ? *given : no_pedal(foot);
    const std::string side = side_of(foot);
    const int thigh = skeleton.index(side + "thigh");
    const int shank = skeleton.index(side + "shank");
    const Segment& t = skeleton.segments[thigh];
    const Segment& s = skeleton.segments[shank];
    const Quaternion turn = plate_turn(pedal, up);
    const Vector3 ankle =
        pedal.heel + turn * Vector3(kHeelBehind, 0.0, shank_end_above_sole(skeleton));
    const Vector3 hip = t.joint_rest;
    const Vector3 towards(1.0, foot == Limb::left_foot ? kOutward : -kOutward, 0.6);
    const double thigh_length = (t.end_rest - t.joint_rest).norm();
    const double shank_length = (s.end_rest - s.joint_rest).norm();
    const Vector3 knee = knee_between(hip, ankle, thigh_length, shank_length, towards);
    const Vector3 hinge = towards.cross(ankle - hip).normalized();
    const Quaternion pelvis = posture.joints[0];
    const Quaternion of_thigh = rod(knee - hip, hinge);
    const Quaternion of_shank = rod(ankle - knee, hinge);
    posture.joints[thigh] = (pelvis.conjugate() * of_thigh).normalized();
    posture.joints[shank] = (of_thigh.conjugate() * of_shank).normalized();
    posture.joints[skeleton.index(side + "foot")] = (of_shank.conjugate() * turn).normalized();
    return std::max(0.0, (ankle - hip).norm() - thigh_length - shank_length);
}

Posture seated(const Skeleton& skeleton, const score::Kit& kit, double left_up, double right_up) {
    Posture posture(skeleton);
    posture.joints[skeleton.index("abdomen")] = from_euler_zyx({0.0, kLean, 0.0});
    posture.joints[skeleton.index("chest")] = from_euler_zyx({0.0, kLean, 0.0});
    posture.joints[skeleton.index("head")] = from_euler_zyx({0.0, 2.0 * kLean, 0.0});
    for (const Hand hand : {Hand::left, Hand::right}) {
        const double out = hand == Hand::left ? 1.0 : -1.0;
        const std::string side = Skeleton::side(hand);
        posture.joints[skeleton.index(side + "upper_arm")] = from_euler_zyx({0.0, 0.0, 0.28 * out});
        posture.joints[skeleton.index(side + "forearm")] = from_euler_zyx({-0.45 * out, 0.10, 0.0});
    }
    put_foot(skeleton, kit, Limb::left_foot, left_up, posture);
    put_foot(skeleton, kit, Limb::right_foot, right_up, posture);
    return posture;
}

Vector3 ball_of(const Skeleton& skeleton, const Placement& placement, Limb foot) {
    const int i = skeleton.index(side_of(foot) + "foot");
    return placement.joint[i] +
           placement.orientation[i] * Vector3(kBallBefore, 0.0, -shank_end_above_sole(skeleton));
}

Vector3 plate_point(const score::Pedal& pedal, double up) {
    return pedal.heel + plate_turn(pedal, up) * Vector3(kHeelBehind + kBallBefore, 0.0, 0.0);
}

double pedal_up(const Skeleton& skeleton, const Placement& placement, const score::Pedal& pedal) {
    const int i = skeleton.index(side_of(pedal.foot) + "foot");
    const double angle = -euler_zyx(placement.orientation[i])[1];
    const double range = pedal.up - pedal.down;
    return range > 0.0 ? (angle - pedal.down) / range : 0.0;
}

}  // namespace percussionist::body
