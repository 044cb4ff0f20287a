#include "sim/kit_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace percussionist::sim {

namespace {

constexpr double kFineRate = 48000;   // [Hz]
constexpr double kSwingRate = 1.3;    // [Hz]
constexpr double kSwingTime = 0.4;    // [s]
constexpr double kArealMass = 11.0;   // of a cymbal: bronze of 1.3 mm [kg/m^2]
constexpr double kStickMass = 0.012;  // at the tip, by which elasticity is told [kg]
constexpr double kStickSpeed = 2.5;   // [m/s]
constexpr double kMostLoss = 3.0;     // dissipation [s/m]
constexpr int kHalvings = 9;

const std::complex<double> kSwing(-1.0 / kSwingTime, 2.0 * std::numbers::pi * kSwingRate);

/// The share of its speed with which a stick comes back from a head at rest.
double comes_back(modal::StruckHead& head, const modal::Mallet& felt) {
    constexpr int kMostSamples = 1440;
    head.rest();
    std::array<modal::Striker, 1> tip;
    tip[0].mallet = felt;
    tip[0].mallet.mass = kStickMass;
    tip[0].velocity = -kStickSpeed;
    for (int i = 0; i < kMostSamples; ++i) {
        head.step(tip);
        if (tip[0].velocity > 0.0 && tip[0].force == 0.0) break;
    }
    return std::max(0.0, tip[0].velocity) / kStickSpeed;
}

/// The loss with which a stick comes back by `share`.
double loss_for(modal::StruckHead& head, modal::Mallet felt, double share) {
    double low = 0.0, high = kMostLoss;
    for (int i = 0; i < kHalvings; ++i) {
        felt.dissipation = 0.5 * (low + high);
        (comes_back(head, felt) > share ? low : high) = felt.dissipation;
    }
    return low;
}

}  // namespace

KitSurfaces::KitSurfaces(const score::Kit& kit, std::vector<modal::Resonator> bodies,
                         OdeWorld& world, double h)
    : kit_(kit), h_(h), hung_(kit.objects.size()), lifts_(kit.objects.size()) {
    find_felts(bodies, kFineRate);
    for (std::size_t o = 0; o < kit.objects.size(); ++o) {
        heads_.push_back(
            std::make_unique<Drumhead>(std::move(bodies[o]), modal::Mallet{}, kFineRate, h));
        if (kit.objects[o].kind == score::ObjectKind::cymbal) hang(o, world);
    }
}

void KitSurfaces::find_felts(const std::vector<modal::Resonator>& bodies, double rate) {
    for (std::size_t e = 0; e < kit_.events.size(); ++e) {
        const score::KitEvent& event = kit_.events[e];
        modal::Mallet felt;
        felt.stiffness = event.stiffness;
        modal::StruckHead head(bodies[event.object], rate);
        head.place(0, std::hypot(event.forward, event.left), std::atan2(event.left, event.forward));
        felt.dissipation = loss_for(head, felt, event.elasticity);
        felts_.push_back(felt);
    }
}

void KitSurfaces::hang(std::size_t object, OdeWorld& world) {
    const score::KitObject& o = kit_.objects[object];
    const double mass = kArealMass * std::numbers::pi * o.radius * o.radius;
    Hung& hung = hung_[object];
    hung.inertia = 0.25 * mass * o.radius * o.radius;
    hung.body = dBodyCreate(world.id());
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, hung.inertia, hung.inertia, 2.0 * hung.inertia, 0, 0, 0);
    dBodySetMass(hung.body, &m);
    dBodySetPosition(hung.body, o.middle.x(), o.middle.y(), o.middle.z());
    const Quaternion q = o.orientation();
    const dQuaternion r = {q.w(), q.x(), q.y(), q.z()};
    dBodySetQuaternion(hung.body, r);
    dJointID ball = dJointCreateBall(world.id(), nullptr);
    dJointAttach(ball, hung.body, nullptr);
    dJointSetBallAnchor(ball, o.middle.x(), o.middle.y(), o.middle.z());
    hung.motor = dJointCreateAMotor(world.id(), nullptr);
    dJointAttach(hung.motor, hung.body, nullptr);
    dJointSetAMotorMode(hung.motor, dAMotorUser);
    dJointSetAMotorNumAxes(hung.motor, 3);
    for (int a = 0; a < 3; ++a) dJointSetAMotorAxis(hung.motor, a, 0, a == 0, a == 1, a == 2);
}

Face KitSurfaces::face(std::size_t object) const {
    const score::KitObject& o = kit_.objects[object];
    Face face;
    face.turn = o.orientation();
    face.middle = o.middle + lifts_[object].height * face.normal();
    face.velocity = lifts_[object].rate * face.normal();
    if (dBodyID body = hung_[object].body) {
        face.turn = orientation(body);
        face.spin = angular_velocity(body);
    }
    return face;
}

Vector3 KitSurfaces::swing(std::size_t object) const {
    dBodyID body = hung_[object].body;
    if (body == nullptr) return Vector3::Zero();
    return linear::quaternion_log(orientation(body) *
                                  kit_.objects[object].orientation().conjugate());
}

Vector3 KitSurfaces::moved(std::size_t object, const Vector3& place, double time) const {
    const score::KitObject& o = kit_.objects[object];
    const Lift& lift = lifts_[object];
    if (hung_[object].body == nullptr) {
        return std::clamp(lift.height + lift.rate * time, 0.0, score::kHatOpens) * o.normal();
    }
    // The spring's course: angle = Im(c exp(kSwing t)) about each axis.
    const Vector3 now = swing(object);
    const Vector3 rate = angular_velocity(hung_[object].body);
    const std::complex<double> later = std::exp(kSwing * time);
    Vector3 then;
    for (int a = 0; a < 3; ++a) {
        const double real = (rate[a] - kSwing.real() * now[a]) / kSwing.imag();
        then[a] = (std::complex<double>(real, now[a]) * later).imag();
    }
    const Vector3 arm = place - o.middle;
    return linear::quaternion_exp(then) * arm - arm;
}

void KitSurfaces::push(std::size_t object, const Vector3& place, const Vector3& impulse) {
    dBodyID body = hung_[object].body;
    if (body == nullptr) return;
    const Vector3 f = impulse / h_;
    dBodyAddForceAtPos(body, f.x(), f.y(), f.z(), place.x(), place.y(), place.z());
}

void KitSurfaces::apply() {
    for (std::size_t o = 0; o < hung_.size(); ++o) {
        const Hung& hung = hung_[o];
        if (hung.body == nullptr) continue;
        const double kp = hung.inertia * std::norm(kSwing);
        const double kd = 2.0 * hung.inertia / kSwingTime;
        const double softness = 1.0 / (h_ * kp + kd);
        const Vector3 speed = -kp * softness * swing(o);
        for (int a = 0; a < 3; ++a) {
            const int group = a * dParamGroup;
            dJointSetAMotorParam(hung.motor, dParamFMax + group, dInfinity);
            dJointSetAMotorParam(hung.motor, dParamCFM + group, softness);
            dJointSetAMotorParam(hung.motor, dParamVel + group, speed[a]);
        }
    }
}

}  // namespace percussionist::sim
