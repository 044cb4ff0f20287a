#include "sim/ode_body.hpp"

#include <cmath>

namespace percussionist::sim {

using body::Hand;
using body::Segment;

OdeBody::OdeBody(const body::Skeleton& skeleton, OdeWorld& world, double mass_factor)
    : skeleton_(skeleton),
      mass_factor_(mass_factor),
      segments_(skeleton.segments.size(), nullptr),
      joints_(skeleton.segments.size(), nullptr),
      motors_(skeleton.segments.size(), nullptr),
      feedback_(skeleton.segments.size(), dJointFeedback{}) {
    for (int i = 1; i < skeleton.size(); ++i) {
        const Segment& s = skeleton.segments[i];
        dBodyID b = dBodyCreate(world.id());
        dBodySetPosition(b, s.com_rest.x(), s.com_rest.y(), s.com_rest.z());
        dBodySetGyroscopicMode(b, 1);
        segments_[i] = b;

        dJointID ball = dJointCreateBall(world.id(), nullptr);
        dJointAttach(ball, b, segments_[s.parent]);
        dJointSetBallAnchor(ball, s.joint_rest.x(), s.joint_rest.y(), s.joint_rest.z());
        joints_[i] = ball;

        dJointID motor = dJointCreateAMotor(world.id(), nullptr);
        dJointAttach(motor, b, segments_[s.parent]);
        dJointSetAMotorMode(motor, dAMotorUser);
        dJointSetAMotorNumAxes(motor, 3);
        for (int a = 0; a < 3; ++a) {
            constexpr int kWorldAxes = 0;
            dJointSetAMotorAxis(motor, a, kWorldAxes, a == 0, a == 1, a == 2);
        }
        motors_[i] = motor;
        dJointSetFeedback(motor, &feedback_[i]);
    }
    weigh();
    for (const Hand hand : {Hand::left, Hand::right}) {
        const int stick = skeleton.stick_index(hand);
        tips_[static_cast<int>(hand)] = {
            segments_[stick], skeleton.tip_rest(hand) - skeleton.segments[stick].com_rest};
    }
}

void OdeBody::weigh() {
    for (int i = 1; i < skeleton_.size(); ++i) {
        const Segment& s = skeleton_.segments[i];
        dMass mass;
        dMassSetParameters(&mass, s.mass, 0, 0, 0, s.inertia.x(), s.inertia.y(), s.inertia.z(), 0,
                           0, 0);
        dMassAdjust(&mass, mass_factor_ * s.mass);
        dBodySetMass(segments_[i], &mass);
    }
}

void OdeBody::place(const body::Placement& placement) {
    for (int i = 1; i < skeleton_.size(); ++i) {
        const Vector3& p = placement.com[i];
        const Quaternion& q = placement.orientation[i];
        const dQuaternion r = {q.w(), q.x(), q.y(), q.z()};
        dBodySetPosition(segments_[i], p.x(), p.y(), p.z());
        dBodySetQuaternion(segments_[i], r);
        dBodySetLinearVel(segments_[i], 0, 0, 0);
        dBodySetAngularVel(segments_[i], 0, 0, 0);
    }
}

void OdeBody::set_velocities(const body::Placement& before, const body::Placement& after,
                             double time) {
    for (int i = 1; i < skeleton_.size(); ++i) {
        const Vector3 v = (after.com[i] - before.com[i]) / time;
        const Vector3 w =
            linear::quaternion_log(after.orientation[i] * before.orientation[i].conjugate()) / time;
        dBodySetLinearVel(segments_[i], v.x(), v.y(), v.z());
        dBodySetAngularVel(segments_[i], w.x(), w.y(), w.z());
    }
}

void OdeBody::read(body::Placement& placement) const {
    for (int i = 1; i < skeleton_.size(); ++i) {
        const Segment& s = skeleton_.segments[i];
        placement.orientation[i] = orientation(segments_[i]);
        placement.com[i] = vector(dBodyGetPosition(segments_[i]));
        placement.joint[i] =
            placement.com[i] + placement.orientation[i] * (s.joint_rest - s.com_rest);
    }
}

void OdeBody::add_joint_torque(int index, const Vector3& t) {
    dBodyAddTorque(segments_[index], t.x(), t.y(), t.z());
    if (dBodyID above = parent(index)) dBodyAddTorque(above, -t.x(), -t.y(), -t.z());
}

Vector3 OdeBody::tip_position(Hand hand) const {
    dVector3 p;
    const Vector3& o = tip(hand).offset;
    dBodyGetRelPointPos(tip(hand).stick, o.x(), o.y(), o.z(), p);
    return vector(p);
}

Vector3 OdeBody::tip_velocity(Hand hand) const {
    dVector3 v;
    const Vector3& o = tip(hand).offset;
    dBodyGetRelPointVel(tip(hand).stick, o.x(), o.y(), o.z(), v);
    return vector(v);
}

void OdeBody::add_tip_force(Hand hand, const Vector3& f) {
    const Vector3& o = tip(hand).offset;
    dBodyAddForceAtRelPos(tip(hand).stick, f.x(), f.y(), f.z(), o.x(), o.y(), o.z());
}

bool OdeBody::sane() const {
    constexpr double kRoom = 50.0;
    for (int i = 1; i < skeleton_.size(); ++i) {
        const Vector3 p = vector(dBodyGetPosition(segments_[i]));
        if (!(p.cwiseAbs().maxCoeff() < kRoom)) return false;
    }
    return true;
}

}  // namespace percussionist::sim
