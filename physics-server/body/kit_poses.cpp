#include "body/kit_poses.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body/inverse_kinematics.hpp"

namespace percussionist::body {

namespace {

using score::Limb;

constexpr double kGripAbove = 0.045;  // the spot, when the tip strikes it [m]
constexpr double kGripShare = 0.45;   // of the tip's rise
constexpr double kTipBack = 0.25;     // towards the drummer, of the rise
constexpr double kWaitsAbove = 0.10;  // what hands play first of all, of one that waits [m]
constexpr double kWaitsBelow = 0.28;  // where a hand comes from and goes [m]
constexpr int kRounds = 60;
constexpr double kNearEnough = 1e-6;  // [m]
constexpr std::array<Limb, 4> kLimbs{Limb::left_hand, Limb::right_hand, Limb::left_foot,
                                     Limb::right_foot};

InverseKinematicsOptions options() {
    InverseKinematicsOptions o;
    o.iterations = 12;
    o.damping = 0.001;
    o.rest_pull = 0.002;
    o.arms = 1.0;  // poses stand still: no part of the arm is too slow for them
    return o;
}

Hand hand_of(Limb limb) {
    return limb == Limb::left_hand ? Hand::left : Hand::right;
}

std::string without_side(const std::string& joint) {
    return joint.substr(joint.find('_') + 1);
}

/// The middle of what hands play first of all.
Vector3 home(const score::Kit& kit) {
    const auto first = std::find_if(kit.events.begin(), kit.events.end(),
                                    [](const score::KitEvent& e) { return !e.foot; });
    return first == kit.events.end() ? kit.objects.front().middle
                                     : kit.objects[first->object].middle;
}

/// Both tips where they are, as targets; one of them is then moved.
ArmTargets targets_here(const Skeleton& skeleton, const InverseKinematics& kinematics,
                        const Posture& posture) {
    Placement placement(skeleton);
    forward_kinematics(skeleton, posture, placement);
    ArmTargets targets;
    for (const Hand hand : {Hand::left, Hand::right}) {
        ArmTarget& target = targets[static_cast<int>(hand)];
        target.tip = placement.tip(skeleton, hand);
        target.grip_height = kinematics.grip(placement, hand).z();
    }
    return targets;
}

/// Goes there from `posture`; how far off it stays [m].
double reach(InverseKinematics& kinematics, const ArmTargets& targets, Posture& posture) {
    Placement placement(kinematics.skeleton());
    double off = 0.0;
    for (int i = 0; i < kRounds; ++i) {
        off = kinematics.solve(targets, posture, placement);
        if (off < kNearEnough) break;
    }
    return off;
}

}  // namespace

KitPoses::KitPoses(const Skeleton& skeleton, const score::Kit& kit)
    : skeleton_(skeleton), kit_(kit), seat_(seated(skeleton, kit, 0.0, 0.5)) {
    for (const Limb limb : kLimbs) {
        parts_[index(limb)] = parts_of(skeleton, limb);
        strikes_[index(limb)].resize(kit.events.size());
    }
    InverseKinematics kinematics(skeleton, options());
    kinematics.set_rest(seat_);
    for (const char* trunk : {"abdomen", "chest"}) {
        kinematics.set_readiness(skeleton.index(trunk), Vector3::Zero());
    }
    add_hand(kinematics, Limb::left_hand);
    add_hand(kinematics, Limb::right_hand);
    add_foot(Limb::left_foot);
    add_foot(Limb::right_foot);
    for (const score::PoseEdit& e : kit.poses) edit(e);
}

Vector3 KitPoses::tip(Limb hand, const LimbPose& pose) const {
    Posture posture = seat_;
    const std::vector<int>& segments = parts(hand).segments;
    for (std::size_t j = 0; j < segments.size(); ++j) posture.joints[segments[j]] = pose[j];
    Placement placement(skeleton_);
    forward_kinematics(skeleton_, posture, placement);
    return placement.tip(skeleton_, hand == Limb::left_hand ? Hand::left : Hand::right);
}

LimbPose KitPoses::taken(Limb limb, const Posture& posture) const {
    LimbPose pose;
    for (const int segment : parts(limb).segments) pose.push_back(posture.joints[segment]);
    return pose;
}

void KitPoses::add_hand(InverseKinematics& kinematics, Limb limb) {
    const int h = static_cast<int>(hand_of(limb));
    const double out = limb == Limb::left_hand ? 1.0 : -1.0;
    const ArmTargets here = targets_here(skeleton_, kinematics, seat_);
    ArmTargets targets = here;
    Posture waiting = seat_;
    const Vector3 lap = home(kit_);
    targets[h].tip = lap + Vector3(-0.04, 0.07 * out, kWaitsAbove);
    targets[h].grip_height = targets[h].tip.z() + kGripAbove;
    reach(kinematics, targets, waiting);
    rest_[index(limb)] = taken(limb, waiting);
    Posture above = waiting;
    targets[h].tip.z() += kWaitsBelow;
    targets[h].grip_height += kGripShare * kWaitsBelow;
    reach(kinematics, targets, above);
    above_rest_[index(limb)] = taken(limb, above);
    for (std::size_t e = 0; e < kit_.events.size(); ++e) {
        if (kit_.events[e].foot) continue;
        StrikePoses poses;
        Posture posture = waiting;
        const Vector3 spot = spot_of(kit_, e, limb);
        targets[h].tip = spot + skeleton_.stick.tip_radius * kit_.object_of(e).normal();
        targets[h].grip_height = spot.z() + kGripAbove;
        poses.off = reach(kinematics, targets, posture);
        poses.down = taken(limb, posture);
        const double rise = kit_.drummer.rise;
        targets[h].tip += Vector3(-kTipBack * rise, 0.0, rise);
        targets[h].grip_height += kGripShare * rise;
        reach(kinematics, targets, posture);
        poses.up = taken(limb, posture);
        strikes_[index(limb)][e] = std::move(poses);
    }
}

void KitPoses::add_foot(Limb foot) {
    rest_[index(foot)] = above_rest_[index(foot)] = taken(foot, seat_);
    for (std::size_t e = 0; e < kit_.events.size(); ++e) {
        if (kit_.events[e].foot != foot) continue;
        StrikePoses poses;
        Posture posture = seat_;
        poses.off = put_foot(skeleton_, kit_, foot, 0.0, posture);
        poses.down = taken(foot, posture);
        put_foot(skeleton_, kit_, foot, 1.0, posture);
        poses.up = taken(foot, posture);
        strikes_[index(foot)][e] = std::move(poses);
    }
}

void KitPoses::edit(const score::PoseEdit& edit) {
    const std::vector<int>& segments = parts(edit.limb).segments;
    const auto found = std::find_if(segments.begin(), segments.end(), [&](int segment) {
        return without_side(skeleton_.segments[segment].joint) == edit.joint;
    });
    auto& strike = strikes_[index(edit.limb)][edit.event];
    if (found == segments.end() || !strike) {
        throw std::invalid_argument("kit: pose: the " + std::string(name(edit.limb)) +
                                    " has no joint '" + edit.joint + "' that plays " +
                                    kit_.events[edit.event].name);
    }
    LimbPose& pose = edit.up ? strike->up : strike->down;
    pose[found - segments.begin()] = from_euler_zyx(edit.angles);
    if (!edit.up && score::is_hand(edit.limb)) strike->off = off_spot(edit.limb, edit.event);
}

double KitPoses::off_spot(Limb hand, std::size_t event) const {
    Posture posture = seat_;
    const LimbPose& down = strikes_[index(hand)][event]->down;
    for (std::size_t j = 0; j < down.size(); ++j) {
        posture.joints[parts(hand).segments[j]] = down[j];
    }
    Placement placement(skeleton_);
    forward_kinematics(skeleton_, posture, placement);
    const Vector3 wanted =
        spot_of(kit_, event, hand) + skeleton_.stick.tip_radius * kit_.object_of(event).normal();
    return (placement.tip(skeleton_, hand_of(hand)) - wanted).norm();
}

void note_reach(const KitPoses& poses, score::Kit& kit) {
    for (std::size_t e = 0; e < kit.events.size(); ++e) {
        double least = 1e9;
        bool reached = false;
        for (const Limb limb : kLimbs) {
            const auto& strike = poses.of(limb, e);
            if (!strike) continue;
            const bool there = strike->off <= KitPoses::kReaches;
            least = std::min(least, strike->off);
            reached = reached || there;
            if (score::is_hand(limb)) kit.events[e].reach[index(limb)] = there;
        }
        if (!reached) {
            throw std::invalid_argument("kit: nobody reaches " + kit.events[e].name + ": " +
                                        std::to_string(std::lround(1000.0 * least)) +
                                        " mm are missing");
        }
    }
}

std::vector<score::PoseEdit> all_poses(const Skeleton& skeleton, const KitPoses& poses,
                                       const score::Kit& kit) {
    std::vector<score::PoseEdit> all;
    for (const Limb limb : kLimbs) {
        for (std::size_t e = 0; e < kit.events.size(); ++e) {
            const auto& strike = poses.of(limb, e);
            if (!strike) continue;
            for (const bool up : {false, true}) {
                const LimbPose& pose = up ? strike->up : strike->down;
                for (std::size_t j = 0; j < pose.size(); ++j) {
                    const int segment = poses.parts(limb).segments[j];
                    all.push_back({limb, e, up, without_side(skeleton.segments[segment].joint),
                                   euler_zyx(pose[j])});
                }
            }
        }
    }
    return all;
}

}  // namespace percussionist::body
