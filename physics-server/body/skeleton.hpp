// The body as a tree of rigid segments: 20 segments, 19 ball joints, 57 degrees of freedom.
//
// World frame: x to the front, y to the left, z up; origin on the floor between the feet. At rest
// (every joint at the identity) the body stands with the upper arms down and forearms, hands and
// sticks pointing forward, and every segment's frame is aligned with the world's: a segment's frame
// has its origin in the segment's centre of mass. The pelvis (segment 0) is fixed to the world, the
// player sitting or standing.
//
// Masses, centres of mass and radii of gyration: de Leva 1996 (male). Limb lengths from stature:
// Winter 2009, "Biomechanics and Motor Control of Human Movement", figure 4.1. The share of the
// upper trunk that moves with each clavicle is our choice.
//
// Values; no ODE here. Building allocates; reading is pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "body/joint_limits.hpp"

namespace percussionist::body {

enum class Hand { left = 0, right = 1 };
inline constexpr std::array<Hand, 2> kHands{Hand::left, Hand::right};
constexpr int index(Hand hand) {
    return static_cast<int>(hand);
}

struct Segment {
    std::string name;
    std::string joint;                     ///< the joint that hangs it on its parent
    int parent = -1;                       ///< index, below this segment's own; -1: the pelvis
    Vector3 joint_rest = Vector3::Zero();  ///< the joint's place at rest, world [m]
    Vector3 com_rest = Vector3::Zero();    ///< the centre of mass at rest, world [m]
    double mass = 0.0;                     ///< [kg]
    Vector3 inertia = Vector3::Zero();     ///< principal moments about the centre of mass [kg m^2]
    Vector3 size = Vector3::Zero();        ///< a box that looks like it, for drawing [m]
    Vector3 end_rest = Vector3::Zero();    ///< its far end at rest, world [m]
    double torque_limit = 0.0;             ///< of its joint, each axis [N m]
    double reach = 0.0;                    ///< how readily inverse kinematics moves its joint, 0..1
    JointLimits limits;
};

struct Stick {
    double mass = 0.045;        ///< [kg]
    double length = 0.38;       ///< [m]
    double held_at = 0.03;      ///< distance of the grip from the butt end [m]
    double diameter = 0.014;    ///< [m]
    double tip_radius = 0.012;  ///< of the ball at its end [m]
    /// From the grip to the middle of the tip [m].
    [[nodiscard]] double reach() const { return length - held_at; }
};

/// Lengths of a body, and heights above the floor of one that stands upright [m].
struct Lengths {
    double hip_height, hip_half_width, lumbar_height, thoracic_height, neck_height;
    double shoulder_height, shoulder_half_width;
    double upper_arm, forearm, hand;  ///< the hand to the middle of the third knuckle
    double thigh, shank, foot;
    double lower_trunk, middle_trunk, upper_trunk, head;
};

/// Winter's fractions of stature [m].
Lengths lengths_of(double stature);

struct Anthropometry {
    double stature = 1.75;  ///< [m]
    double mass = 75.0;     ///< [kg]
    Stick stick;
    std::optional<Lengths> lengths;  ///< those measured; none: lengths_of(stature)
};

struct Skeleton {
    std::vector<Segment> segments;  ///< parents before children; 0 is the pelvis
    Stick stick;

    [[nodiscard]] int size() const { return static_cast<int>(segments.size()); }
    /// The index of a segment by name; throws std::out_of_range naming it if there is none.
    [[nodiscard]] int index(const std::string& name) const;
    [[nodiscard]] int stick_index(Hand hand) const { return index(side(hand) + "stick"); }
    [[nodiscard]] int hand_index(Hand hand) const { return index(side(hand) + "hand"); }
    /// The middle of the stick's tip at rest, world [m].
    [[nodiscard]] Vector3 tip_rest(Hand hand) const;
    /// True if `ancestor` is `segment` or lies between it and the pelvis.
    [[nodiscard]] bool moves(int ancestor, int segment) const;
    /// The prefix of the names of one side: "left_" or "right_".
    static std::string side(Hand hand) { return hand == Hand::left ? "left_" : "right_"; }
};

/// Builds the body. Throws std::invalid_argument for a stature outside 0.5 to 2.5 m, a mass outside
/// 10 to 300 kg, a length not above 0 or above 3 m, or a stick that is not one.
Skeleton make_skeleton(const Anthropometry& anthropometry);

}  // namespace percussionist::body
