#include "sim/kit_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace percussionist::sim {

using body::Hand;
using body::kHands;
using score::Limb;

namespace {

constexpr std::array<Limb, 4> kLimbs{Limb::left_hand, Limb::right_hand, Limb::left_foot,
                                     Limb::right_foot};
/// Of the joints, against a person's: key frames turn more sharply than muscles would.
constexpr double kStrength = 3.0;
/// A limb counts as striking from so long before to so long after the contact, and is loose [s].
constexpr double kStrikesBefore = 0.001;
constexpr double kStrikesAfter = 0.007;
constexpr double kLooseBefore = 0.004;
constexpr double kLooseAfter = 0.012;
/// A tip is led to where a face will be from so long before the contact [s], in that time.
constexpr double kLeadTime = 0.08;
constexpr double kLedBefore = 0.008;
constexpr double kLeastLead = 0.02;
constexpr double kSameLead = 0.0002;  // [m]
constexpr double kFarLead = 0.002;    // [m]
/// The speed of a contact that flashes as brightly as can be [m/s].
constexpr double kBrightest = 5.0;

Limb limb_of(Hand hand) {
    return hand == Hand::left ? Limb::left_hand : Limb::right_hand;
}

double step_of(double rate) {
    if (!(rate >= 250.0 && rate <= 4000.0)) {
        throw std::invalid_argument("simulation: rate: expected 250 to 4000 Hz, got " +
                                    std::to_string(rate));
    }
    return 1.0 / rate;
}

}  // namespace

KitSimulation::KitSimulation(const score::Kit& kit, std::vector<modal::Resonator> bodies,
                             const body::Posture& posture, double start, double rate)
    : kit_(kit),
      h_(step_of(rate)),
      start_(start),
      skeleton_(body::make_drummer(kit.drummer)),
      body_(skeleton_, world_),
      controller_(body_, {}, h_),
      pedals_(kit, bodies, world_, h_),
      surfaces_(kit, std::move(bodies), world_, h_),
      kinematics_(skeleton_),
      tips_{StickTip(skeleton_, Hand::left), StickTip(skeleton_, Hand::right)},
      target_(skeleton_),
      actual_(skeleton_),
      flashes_(kit.objects.size()) {
    for (body::Segment& segment : skeleton_.segments) segment.torque_limit *= kStrength;
    for (const Limb limb : kLimbs) {
        parts_[score::index(limb)] = body::parts_of(skeleton_, limb).segments;
    }
    target_.before = target_.now = target_.after = posture;
    forward_kinematics(skeleton_, posture, target_.placed_now);
    target_.placed_before = target_.placed_after = target_.placed_now;
    body_.place(target_.placed_now);
    body_.read(actual_);
}

void KitSimulation::step(const body::Posture& posture, const body::LimbForecasts& forecasts,
                         std::vector<KitContact>& contacts) {
    target_.after = posture;
    forward_kinematics(skeleton_, posture, target_.placed_after);
    lead_tips(forecasts);
    mark_contacts(forecasts);
    controller_.apply(target_);
    pedals_.support(target_, body_);
    press_pedals(contacts);
    strike_faces(forecasts, contacts);
    surfaces_.apply();
    world_.step(h_);
    ++steps_;
    body_.read(actual_);
    target_.advance();
}

/// How far what an event strikes will be from where its spot is told.
Vector3 KitSimulation::next_face(std::size_t event, const Vector3& spot, double left) const {
    const score::KitEvent& e = kit_.events[event];
    const double told = e.hat == score::HatState::open ? score::kOpenHat * score::kHatOpens : 0.0;
    return surfaces_.moved(e.object, spot, left) - told * kit_.object_of(event).normal();
}

void KitSimulation::lead_tips(const body::LimbForecasts& forecasts) {
    const double now = time();
    body::ArmTargets targets;
    double farthest = 0.0;
    for (const Hand hand : kHands) {
        const Limb limb = limb_of(hand);
        const body::ForecastStroke& next = forecasts[score::index(limb)].next;
        const double left = next.time - now;
        MovingPlace& lead = leads_[index(hand)];
        const bool held = now < forecasts[score::index(limb)].last.time + kStrikesAfter;
        if (left < kLeadTime && left > kLedBefore && !held) {
            const Vector3 spot = score::spot_of(kit_, next.event, limb);
            const Vector3 goal = next_face(next.event, spot, left);
            if ((goal - lead.goal()).norm() > kSameLead) {
                lead.go(now, goal, std::max(kLeastLead, left - kLedBefore));
            }
        }
        const Vector3 off = lead.at(now + h_);
        farthest = std::max(farthest, off.norm());
        targets[index(hand)].tip = target_.placed_after.tip(skeleton_, hand) + off;
    }
    // Wrists and fingers come nearer each time; farther leads take more.
    const int times = farthest > kFarLead ? 4 : farthest > 0.0 ? 1 : 0;
    for (int i = 0; i < times; ++i) {
        kinematics_.reach_by_hands(targets, target_.after, target_.placed_after);
    }
}

void KitSimulation::mark_contacts(const body::LimbForecasts& forecasts) {
    const double now = time();
    for (const Limb limb : kLimbs) {
        const body::LimbForecast& f = forecasts[score::index(limb)];
        const auto about = [&](double before, double after) {
            return f.next.time - now < before || now - f.last.time < after;
        };
        const std::vector<int>& parts = parts_[score::index(limb)];
        for (const int segment : parts) {
            target_.strikes[segment] = about(kStrikesBefore, kStrikesAfter);
        }
        target_.loose[parts.back()] = about(kLooseBefore, kLooseAfter);
    }
}

void KitSimulation::strike_faces(const body::LimbForecasts& forecasts,
                                 std::vector<KitContact>& contacts) {
    std::array<Vector3, 2> impulses{Vector3::Zero(), Vector3::Zero()};
    for (StickTip& tip : tips_) tip.look(body_);
    for (std::size_t o = 0; o < surfaces_.size(); ++o) {
        const Face face = surfaces_.face(o);
        Drumhead& head = surfaces_.head(o);
        std::array<TouchingTip, 2> touching;
        for (const Hand hand : kHands) {
            const auto i = static_cast<std::size_t>(hand);
            touching[i] = tips_[i].against(face, head, actual_, controller_.resistance(), h_);
            const body::LimbForecast& f = forecasts[score::index(limb_of(hand))];
            const std::size_t event = f.next.time - time() < 0.03 ? f.next.event : f.last.event;
            if (!head.touches(i) && kit_.events[event].object == o) {
                head.set_felt(i, surfaces_.felt(event));
            }
        }
        ended_.clear();
        const std::array<double, 2> given = head.step(time(), touching, ended_);
        for (const ContactEvent& event : ended_) tell(limb_of(event.hand), o, event, contacts);
        for (std::size_t i = 0; i < given.size(); ++i) {
            if (given[i] == 0.0) continue;
            const Vector3 impulse = given[i] * face.normal();
            impulses[i] += impulse;
            surfaces_.push(o, tips_[i].position(), -impulse);
        }
    }
    for (const Hand hand : kHands) {
        const Vector3& impulse = impulses[index(hand)];
        tips_[index(hand)].struck(impulse);
        if (!impulse.isZero(0.0)) body_.add_tip_force(hand, impulse / h_);
    }
}

void KitSimulation::press_pedals(std::vector<KitContact>& contacts) {
    ended_.clear();
    pedals_.apply(time(), body_, actual_, ended_);
    for (std::size_t i = 0; i < pedals_.size(); ++i) {
        const score::Pedal& pedal = pedals_.pedal(i);
        for (const ContactEvent& event : ended_) {
            const auto object = static_cast<std::size_t>(event.drum);
            if (object == pedal.object) tell(pedal.foot, object, event, contacts);
        }
        if (kit_.objects[pedal.object].kind == score::ObjectKind::hi_hat) {
            surfaces_.lift(pedal.object, score::kHatOpens * pedals_.up(i),
                           score::kHatOpens * pedals_.rate(i));
        }
    }
}

void KitSimulation::tell(Limb limb, std::size_t object, const ContactEvent& event,
                         std::vector<KitContact>& contacts) {
    contacts.push_back({limb, object, event});
    contacts.back().contact.drum = static_cast<int>(object);
    flashes_[object] = {event.instant, std::min(1.0, -event.velocity.z() / kBrightest)};
}

void KitSimulation::kit_state(std::vector<body::ObjectState>& states) const {
    states.assign(kit_.objects.size(), {});
    for (std::size_t o = 0; o < states.size(); ++o) {
        const Flash& flash = flashes_[o];
        states[o].flash =
            flash.height * std::exp(-std::max(0.0, time() - flash.time) / body::kFlashTime);
        states[o].turn = surfaces_.swing(o);
    }
    for (std::size_t i = 0; i < pedals_.size(); ++i) {
        body::ObjectState& state = states[pedals_.pedal(i).object];
        state.pedal = pedals_.up(i);
        if (kit_.objects[pedals_.pedal(i).object].kind == score::ObjectKind::hi_hat) {
            state.lift = score::kHatOpens * state.pedal;
        } else {
            state.beater = body::kBeaterTurns * state.pedal;
        }
    }
}

}  // namespace percussionist::sim
