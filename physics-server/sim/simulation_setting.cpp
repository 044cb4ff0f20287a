// What the percussionist plays with and where, and how the sticks are held: all that can be changed
// between two steps beside the motion itself.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/linear/rotation.hpp"
#include "sim/simulation.hpp"

namespace percussionist::sim {

using body::Hand;
using body::kHands;

namespace {

/// How far a forearm is turned for thumbs up [rad].
constexpr double kThumbsUp = 1.2;
/// In which time the place of a stroke, or the head, moves to another [s].
constexpr double kMove = 0.4;
/// Near the middle of the head the sticks are not as far apart: this share of their distance from
/// it.
constexpr double kMostSideways = 0.7;
/// In which time one grip becomes the other [s].
constexpr double kTurnGrip = 0.5;

void check_range(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw std::invalid_argument(std::string(what) + ": expected " + std::to_string(least) + " to " +
                                std::to_string(most) + ", got " + std::to_string(value));
}

}  // namespace

/// The sticks meet the head side by side, at the same distance from its middle.
Vector3 Simulation::offset(Hand hand) const {
    const double radius = strike_radius_[index(hand)] * options_.head.membrane.radius;
    const double apart = std::min(0.5 * options_.strikes_apart, kMostSideways * radius);
    return {-std::sqrt(radius * radius - apart * apart), hand == Hand::left ? apart : -apart, 0.0};
}

/// The head stands where the sticks meet it with the arms as they are at rest: who plays further in
/// stands nearer. Or where a clip strikes it.
Vector3 Simulation::head_goal() const {
    if (played_ && !played_->strokes().empty()) {
        const Vector3 touch = played_->place() - skeleton_.stick.tip_radius * Vector3::UnitZ();
        return touch - 0.5 * (offset(Hand::left) + offset(Hand::right));
    }
    const auto mean_x = [](const Vector3& left, const Vector3& right) {
        return 0.5 * (left.x() + right.x());
    };
    const double reach = mean_x(skeleton_.tip_rest(Hand::left), skeleton_.tip_rest(Hand::right));
    return {reach - mean_x(offset(Hand::left), offset(Hand::right)), 0.0, options_.head_height};
}

void Simulation::move_places() {
    for (const Hand hand : kHands) offsets_[index(hand)].go(time(), offset(hand), kMove);
    head_place_.go(time(), head_goal(), kMove);
}

void Simulation::forecast() {
    const double mass = tips_[0].bare_mass(actual_, Vector3::UnitZ());
    forecast_ = std::make_unique<ImpactForecast>(options_.head, h_, mass, offset(Hand::left));
}

void Simulation::set_strike_radius(Hand hand, double share) {
    check_range("strike radius", share, 0.05, 0.95);
    strike_radius_[index(hand)] = share;
    move_places();
}

void Simulation::set_head_height(double height) {
    check_range("height of the head [m]", height, 0.6, 1.2);
    options_.head_height = height;
    move_places();
}

void Simulation::set_membrane(const modal::Membrane& membrane) {
    check_range("radius of the head [m]", membrane.radius, 0.1, 0.6);
    head_->tune(membrane, options_.head.decay);
    options_.head.membrane = membrane;
    move_places();
    forecast();
}

void Simulation::set_mallet(double mass, double stiffness) {
    check_range("mass of a stick [kg]", mass, 0.01, 0.3);
    check_range("stiffness of a tip", stiffness, 1e5, 1e11);
    for (const Hand hand : kHands) {
        body::Segment& stick = skeleton_.segments[skeleton_.stick_index(hand)];
        stick.inertia *= mass / stick.mass;
        stick.mass = mass;
    }
    skeleton_.stick.mass = mass;
    body_->weigh();
    controller_->weigh();
    head_->set_tip_stiffness(stiffness);
    options_.head.tip.stiffness = stiffness;
    options_.person.stick.mass = mass;
    forecast();
}

void Simulation::set_grip(body::Grip grip) {
    thumbs_up_.go(time(), grip == body::Grip::french ? 1.0 : 0.0, kTurnGrip);
    strokes_rest_ = grip_rest(thumbs_up_.goal());
    if (!clip_) kinematics_.set_rest(strokes_rest_);
    turn_grip(time());
}

/// The posture to which strokes are pulled: palms down (0) to thumbs up (1).
body::Posture Simulation::grip_rest(double thumbs_up) const {
    body::Posture rest(skeleton_);
    for (const Hand hand : kHands) {
        const double inwards = hand == Hand::left ? -1.0 : 1.0;
        rest.joints[skeleton_.index(body::Skeleton::side(hand) + "forearm")] =
            linear::quaternion_exp(inwards * thumbs_up * kThumbsUp * Vector3::UnitX());
    }
    return rest;
}

/// On the way from one grip to the other the tips do as they are asked to.
void Simulation::turn_grip(double t) {
    const double share = thumbs_up_.at(t);
    if (!clip_) kinematics_.pull_to(grip_rest(share));
    for (const Hand hand : kHands) {
        // With thumbs up what swings a stick up and down is each joint's own z.
        for (const char* part : {"forearm", "hand", "stick"}) {
            const int segment = skeleton_.index(body::Skeleton::side(hand) + part);
            const Vector3 usual =
                body::InverseKinematics::usual_readiness(skeleton_.segments[segment]);
            const Vector3 turned(usual.x(), usual.z(), usual.y());
            kinematics_.set_readiness(segment, usual + share * (turned - usual));
        }
    }
}

}  // namespace percussionist::sim
