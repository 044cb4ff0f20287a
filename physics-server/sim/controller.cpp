#include "sim/controller.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "body/joint_strength.hpp"

namespace percussionist::sim {

using body::Hand;
using body::Segment;
using body::Skeleton;
using linear::quaternion_log;

namespace {

/// Most that the papers' law may have, in units of the lighter side's inertia by the step
/// (squared): an explicit spring is stable below 4, an explicit damper below 2, and joints are
/// coupled.
constexpr double kMostStiffness = 0.5;
constexpr double kMostDamping = 0.5;
/// Beyond its limits a joint is pushed back at this frequency [Hz].
constexpr double kStopFrequency = 40.0;
/// A joint that is so far beyond its limits is against its stop [rad].
constexpr double kStopped = 1e-3;

/// The reduced inertia, by axis, of a joint whose two sides turn freely against each other.
Vector3 reduced_inertia(const Skeleton& skeleton, int i) {
    const Segment& s = skeleton.segments[i];
    const Vector3 d = s.com_rest - s.joint_rest;
    const Vector3 own =
        s.inertia + s.mass * (d.squaredNorm() * Vector3::Ones() - d.cwiseProduct(d));
    if (s.parent <= 0) return own;
    const Vector3 above = skeleton.segments[s.parent].inertia;
    return (own.cwiseInverse() + above.cwiseInverse()).cwiseInverse();
}

void check_gains(double frequency, double damping) {
    if (!(frequency >= 0.1 && frequency <= 1000.0)) {
        throw std::invalid_argument("control: frequency: expected 0.1 to 1000 Hz, got " +
                                    std::to_string(frequency));
    }
    if (!(damping >= 0.01 && damping <= 10.0)) {
        throw std::invalid_argument("control: damping: expected 0.01 to 10, got " +
                                    std::to_string(damping));
    }
}

}  // namespace

Target::Target(const Skeleton& skeleton)
    : before(skeleton),
      now(skeleton),
      after(skeleton),
      placed_before(skeleton),
      placed_now(skeleton),
      placed_after(skeleton),
      strikes(skeleton.segments.size(), 0),
      loose(skeleton.segments.size(), 0) {}

void Target::advance() {
    std::swap(before, now);
    std::swap(placed_before, placed_now);
    now = after;
    placed_now = placed_after;
}

Controller::Controller(OdeBody& body, const ControlOptions& options, double h)
    : body_(body),
      options_(options),
      h_(h),
      resistance_(body.skeleton().segments.size(), 0.0),
      own_frequency_(body.skeleton().segments.size(), 0.0),
      own_damping_(body.skeleton().segments.size(), 0.0),
      added_(body.skeleton().segments.size(), Vector3::Zero()),
      hand_of_grip_(body.skeleton().segments.size(), -1),
      acceleration_(body.skeleton()),
      forecast_(body.skeleton()),
      torques_(body.skeleton().segments.size(), Vector3::Zero()) {
    const Skeleton& skeleton = body.skeleton();
    inertia_.resize(skeleton.segments.size(), 0.0);
    own_inertia_.resize(skeleton.segments.size(), Vector3::Zero());
    weigh();
    for (const Hand hand : {Hand::left, Hand::right}) {
        hand_of_grip_[skeleton.stick_index(hand)] = static_cast<int>(hand);
    }
}

void Controller::weigh() {
    const Skeleton& skeleton = body_.skeleton();
    for (int i = 1; i < skeleton.size(); ++i) {
        inertia_[i] = body::hanging_inertia(skeleton, i);
        own_inertia_[i] = reduced_inertia(skeleton, i);
    }
}

Controller::Gains Controller::gains(int joint, double frequency) const {
    const double w = 2.0 * std::numbers::pi * frequency;
    const double damping = own_damping_[joint] > 0.0 ? own_damping_[joint] : options_.damping;
    return {inertia_[joint] * w * w, 2.0 * damping * inertia_[joint] * w};
}

void Controller::set_gains(double frequency, double damping) {
    check_gains(frequency, damping);
    options_.frequency = options_.grip_frequency = frequency;
    options_.damping = damping;
    own_frequency_.assign(own_frequency_.size(), 0.0);
    own_damping_.assign(own_damping_.size(), 0.0);
}

void Controller::set_joint_gains(int segment, double frequency, double damping) {
    check_gains(frequency, damping);
    own_frequency_.at(segment) = frequency;
    own_damping_.at(segment) = damping;
}

void Controller::set_paper_gains(double frequency, double damping) {
    check_gains(frequency, damping);
    options_.paper_frequency = frequency;
    options_.paper_damping = damping;
}

void Controller::add_torque(int joint, const Vector3& torque) {
    const double limit = body_.skeleton().segments[joint].torque_limit;
    added_[joint] = torque.cwiseMax(-limit).cwiseMin(limit);
    body_.add_joint_torque(joint, added_[joint]);
}

double Controller::frequency(int joint, const Target& target) const {
    const int hand = hand_of_grip_[joint];
    if (target.loose[joint]) return options_.contact_frequency;
    if (own_frequency_[joint] > 0.0) return own_frequency_[joint];
    return hand < 0 ? options_.frequency : options_.grip_frequency;
}

void Controller::apply(const Target& target) {
    if (options_.law == Law::implicit) {
        feed_forward(target);
        for (int i = 1; i < body_.skeleton().size(); ++i) apply_implicit(i, target);
    } else {
        for (int i = 1; i < body_.skeleton().size(); ++i) apply_paper(i, target);
    }
}

void Controller::feed_forward(const Target& target) {
    central_difference(body_.skeleton(), target.placed_before, target.placed_now,
                       target.placed_after, h_, forecast_);
    for (int i = 0; i < body_.skeleton().size(); ++i) {
        if (target.strikes[i]) continue;
        acceleration_.linear[i] = forecast_.linear[i];
        acceleration_.momentum[i] = forecast_.momentum[i];
    }
    joint_torques(body_.skeleton(), target.placed_now, acceleration_, torques_);
    for (int i = 1; i < body_.skeleton().size(); ++i) {
        // From the frame of the target's parent to that of the parent as it is.
        const int parent = body_.skeleton().segments[i].parent;
        const Quaternion turn =
            orientation(body_.segment(parent)) * target.placed_now.orientation[parent].conjugate();
        add_torque(i, turn * torques_[i]);
    }
}

void Controller::apply_implicit(int joint, const Target& target) {
    const Segment& s = body_.skeleton().segments[joint];
    const Quaternion above = orientation(body_.parent(joint));
    const Quaternion relative = above.conjugate() * orientation(body_.segment(joint));
    const bool stopped = body::clamp(relative, s.limits).angularDistance(relative) > kStopped;

    const Quaternion now = body::clamp(target.now.joints[joint], s.limits);
    const Quaternion after = body::clamp(target.after.joints[joint], s.limits);
    const Vector3 error = above * quaternion_log(now * relative.conjugate());
    // ODE moves a body by its velocity at the step's end: what leads from now to after.
    const Vector3 rate = above * (quaternion_log(after * now.conjugate()) / h_);
    const Gains g = gains(joint, stopped ? kStopFrequency : frequency(joint, target));
    drive_motor(joint, error, rate, g, stopped ? dInfinity : s.torque_limit);
}

void Controller::drive_motor(int joint, const Vector3& error, const Vector3& rate, const Gains& g,
                             double most) {
    const double softness = 1.0 / (h_ * g.kp + g.kd);
    const Vector3 speed = g.kp * softness * error + rate;
    for (int a = 0; a < 3; ++a) {
        const int group = a * dParamGroup;
        dJointSetAMotorParam(body_.motor(joint), dParamFMax + group, most);
        dJointSetAMotorParam(body_.motor(joint), dParamCFM + group, softness);
        dJointSetAMotorParam(body_.motor(joint), dParamVel + group, speed[a]);
    }
    resistance_[joint] = h_ * g.kd + h_ * h_ * g.kp;
}

void Controller::apply_paper(int joint, const Target& target) {
    const Quaternion above = orientation(body_.parent(joint));
    const Quaternion here = orientation(body_.segment(joint));
    const Quaternion relative = above.conjugate() * here;
    const body::JointLimits& limits = body_.skeleton().segments[joint].limits;
    const Quaternion allowed = body::clamp(relative, limits);
    if (allowed.angularDistance(relative) > kStopped) {
        add_torque(joint, Vector3::Zero());
        drive_motor(joint, above * quaternion_log(allowed * relative.conjugate()), Vector3::Zero(),
                    gains(joint, kStopFrequency), dInfinity);
        return;
    }
    const Quaternion now = body::clamp(target.now.joints[joint], limits);
    const Vector3 error = here.conjugate() * (above * quaternion_log(now * relative.conjugate()));
    const Vector3 rate = here.conjugate() * (angular_velocity(body_.segment(joint)) -
                                             angular_velocity(body_.parent(joint)));
    const double w = 2.0 * std::numbers::pi * options_.paper_frequency;
    // As stiff as asked for, as far as the lighter side of the joint stands it in a step.
    const Vector3 most_ks = kMostStiffness / (h_ * h_) * own_inertia_[joint];
    const Vector3 most_kd = kMostDamping / h_ * own_inertia_[joint];
    const Vector3 ks = most_ks.cwiseMin(Vector3::Constant(inertia_[joint] * w * w));
    const Vector3 kd =
        most_kd.cwiseMin(Vector3::Constant(2.0 * options_.paper_damping * inertia_[joint] * w));
    const Vector3 torque = ks.cwiseProduct(error) - kd.cwiseProduct(rate);
    add_torque(joint, here * torque);
    for (int a = 0; a < 3; ++a) {
        dJointSetAMotorParam(body_.motor(joint), dParamFMax + a * dParamGroup, 0.0);
    }
    resistance_[joint] = 0.0;
}

}  // namespace percussionist::sim
