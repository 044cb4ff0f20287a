#include "sim/kit_pedals.hpp"

#include <algorithm>
#include <cmath>

#include "body/kit_motion.hpp"

namespace percussionist::sim {

namespace {

constexpr double kFineRate = 48000;   // [Hz]
constexpr double kPlateMass = 0.25;   // [kg]
constexpr double kBeaterArm = 0.2;    // [m]
constexpr double kBeaterMass = 0.09;  // at its end [kg]
constexpr double kHatMass = 1.0;      // of the upper cymbal and rod [kg]
constexpr double kHatFelt = 1e9;      // of two cymbals' edges, see modal::Mallet
constexpr double kSpring = 4.0;       // torque when up, and twice as much when pressed [N m]
constexpr double kFriction = 0.02;    // of the hinge [N m s]
constexpr double kSole = 4e5;         // a sole's stiffness [N/m]
constexpr double kSoleLoss = 600.0;   // and its damper [N s/m]
constexpr double kRests = 12.0;       // a foot on what it keeps pressed, at least [N]
constexpr double kMostPress = 400.0;  // [N]
constexpr double kTold = 0.03;        // a contact below this speed is none [m/s]
constexpr double kBelow = 0.10;       // a plate may be pressed so far beyond its mark [rad]
constexpr double kAbove = 0.03;       // and rise [rad]

double spring(double up) {
    return kSpring * (2.0 - up);
}

}  // namespace

KitPedals::KitPedals(const score::Kit& kit, const std::vector<modal::Resonator>& bodies,
                     OdeWorld& world, double h)
    : kit_(kit), world_(world), h_(h), touching_(dJointGroupCreate(0)) {
    const body::Skeleton skeleton = body::make_drummer(kit.drummer);
    plates_.resize(kit.pedals.size());
    for (std::size_t i = 0; i < plates_.size(); ++i) {
        plates_[i].leg = body::parts_of(skeleton, kit.pedals[i].foot).segments;
        make(i, bodies[kit.pedals[i].object], world);
    }
}

KitPedals::~KitPedals() {
    dJointGroupDestroy(touching_);
}

bool KitPedals::hat(std::size_t i) const {
    return kit_.objects[kit_.pedals[i].object].kind == score::ObjectKind::hi_hat;
}

void KitPedals::make(std::size_t i, const modal::Resonator& body, OdeWorld& world) {
    const score::Pedal& pedal = kit_.pedals[i];
    Plate& plate = plates_[i];
    const double way = pedal.up - pedal.down;
    plate.gear = (hat(i) ? score::kHatOpens : kBeaterArm * body::kBeaterTurns) / way;
    const double driven = hat(i) ? kHatMass : kBeaterMass;
    const double own = kPlateMass * pedal.length * pedal.length / 12.0;
    const double geared = driven * plate.gear * plate.gear;
    plate.inertia = own + kPlateMass * pedal.length * pedal.length / 4.0 + geared;
    plate.body = dBodyCreate(world.id());
    dMass mass;
    dMassSetParameters(&mass, kPlateMass, 0, 0, 0, own, own + geared, own, 0, 0, 0);
    dBodySetMass(plate.body, &mass);
    dBodySetGravityMode(plate.body, 0);  // the spring balances it
    const Quaternion q = body::from_euler_zyx({pedal.direction, -pedal.down, 0.0});
    const Vector3 middle = pedal.heel + q * Vector3(0.5 * pedal.length, 0.0, 0.0);
    const dQuaternion r = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(plate.body, middle.x(), middle.y(), middle.z());
    dBodySetQuaternion(plate.body, r);
    plate.hinge = dJointCreateHinge(world.id(), nullptr);
    dJointAttach(plate.hinge, plate.body, nullptr);
    dJointSetHingeAnchor(plate.hinge, pedal.heel.x(), pedal.heel.y(), pedal.heel.z());
    const Vector3 axis = q * -Vector3::UnitY();  // turning about it lifts the toe
    dJointSetHingeAxis(plate.hinge, axis.x(), axis.y(), axis.z());
    dJointSetHingeParam(plate.hinge, dParamLoStop, -kBelow);
    dJointSetHingeParam(plate.hinge, dParamHiStop, way + kAbove);
    modal::Mallet felt;
    felt.stiffness = kHatFelt;
    for (const score::KitEvent& event : kit_.events) {
        if (!hat(i) && event.foot == pedal.foot) felt.stiffness = event.stiffness;
    }
    plate.head = std::make_unique<Drumhead>(body, felt, kFineRate, h_);
}

double KitPedals::angle(const Plate& plate) const {
    return dJointGetHingeAngle(plate.hinge);
}

double KitPedals::angle_rate(const Plate& plate) const {
    return dJointGetHingeAngleRate(plate.hinge);
}

double KitPedals::up(std::size_t i) const {
    return angle(plates_[i]) / (kit_.pedals[i].up - kit_.pedals[i].down);
}

double KitPedals::rate(std::size_t i) const {
    return angle_rate(plates_[i]) / (kit_.pedals[i].up - kit_.pedals[i].down);
}

void KitPedals::apply(double time, const OdeBody& body, const body::Placement& actual,
                      std::vector<ContactEvent>& contacts) {
    dJointGroupEmpty(touching_);
    for (std::size_t i = 0; i < plates_.size(); ++i) {
        dJointAddHingeTorque(plates_[i].hinge, spring(up(i)) - kFriction * angle_rate(plates_[i]));
        press(plates_[i], kit_.pedals[i], body, actual);
        drive(i, time, contacts);
    }
}

void KitPedals::support(const Target& target, OdeBody& body) const {
    constexpr double kPressed = 0.02;
    for (std::size_t i = 0; i < plates_.size(); ++i) {
        const score::Pedal& pedal = kit_.pedals[i];
        const Plate& plate = plates_[i];
        const auto up_in = [&](const body::Placement& placed) {
            return body::pedal_up(body.skeleton(), placed, pedal);
        };
        const double up = up_in(target.placed_now);
        double torque = spring(std::clamp(up, 0.0, 1.0));
        if (!target.strikes[plate.leg.back()]) {
            const double bend = up_in(target.placed_before) - 2.0 * up + up_in(target.placed_after);
            torque -= plate.inertia * (pedal.up - pedal.down) * bend / (h_ * h_);
        }
        const Vector3 ball = body::ball_of(body.skeleton(), target.placed_now, pedal.foot);
        const double least = up < kPressed ? torque / (ball - pedal.heel).norm() + kRests : 0.0;
        const double force =
            std::clamp(torque / (ball - pedal.heel).norm(), std::max(0.0, least), kMostPress);
        const Vector3 normal = orientation(plate.body) * Vector3::UnitZ();
        for (const int segment : plate.leg) {
            const Vector3 arm = ball - target.placed_now.joint[segment];
            body.add_joint_torque(segment, arm.cross(-force * normal));
        }
    }
}

void KitPedals::press(const Plate& plate, const score::Pedal& pedal, const OdeBody& body,
                      const body::Placement& actual) {
    const Vector3 ball = body::ball_of(body.skeleton(), actual, pedal.foot);
    const Vector3 normal = orientation(plate.body) * Vector3::UnitZ();
    const double depth = -normal.dot(ball - pedal.heel);
    if (depth <= 0.0) return;
    dContact contact{};
    contact.surface.mode = dContactSoftERP | dContactSoftCFM;
    contact.surface.mu = 0.0;
    contact.surface.soft_erp = h_ * kSole / (h_ * kSole + kSoleLoss);
    contact.surface.soft_cfm = 1.0 / (h_ * kSole + kSoleLoss);
    contact.geom.depth = depth;
    for (int a = 0; a < 3; ++a) {
        contact.geom.pos[a] = ball[a];
        contact.geom.normal[a] = normal[a];
    }
    const dJointID joint = dJointCreateContact(world_.id(), touching_, &contact);
    dJointAttach(joint, body.segment(plate.leg.back()), plate.body);
}

void KitPedals::drive(std::size_t i, double time, std::vector<ContactEvent>& contacts) {
    Plate& plate = plates_[i];
    std::array<TouchingTip, 2> tips;
    tips[1].place.z() = 1.0;
    const double rate = angle_rate(plate);
    TouchingTip& tip = tips[0];
    // A hi-hat's cymbals meet at their edges.
    tip.place = {hat(i) ? 0.9 * kit_.objects[kit_.pedals[i].object].radius : 0.0, 0.0,
                 plate.gear * angle(plate)};
    tip.velocity.z() = plate.gear * rate;
    tip.mass = tip.bare_mass = plate.inertia / (plate.gear * plate.gear);
    const double other = (rate - plate.last_rate) / h_ - plate.last_torque / plate.inertia;
    tip.acceleration = std::clamp(plate.gear * other, -200.0, 200.0);
    plate.last_rate = rate;
    const std::size_t known = contacts.size();
    const double impulse = plate.head->step(time, tips, contacts)[0];
    // What is kept pressed trembles: that is no stroke.
    const auto first = contacts.begin() + static_cast<std::ptrdiff_t>(known);
    contacts.erase(std::remove_if(first, contacts.end(),
                                  [](const ContactEvent& c) { return c.velocity.z() > -kTold; }),
                   contacts.end());
    for (std::size_t c = known; c < contacts.size(); ++c) {
        contacts[c].drum = static_cast<int>(kit_.pedals[i].object);
    }
    plate.last_torque = plate.gear * impulse / h_;
    if (impulse != 0.0) dJointAddHingeTorque(plate.hinge, plate.last_torque);
}

}  // namespace percussionist::sim
