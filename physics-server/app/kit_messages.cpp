#include "app/kit_messages.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/body_messages.hpp"
#include "app/kit_figure.hpp"
#include "core/score/stroke_plan.hpp"

namespace percussionist::app {

namespace {

using linear::Vector3;

/// Where on the face, from its middle, forward and to the left [m].
Vector3 place_on(const score::KitEvent& event, score::Limb limb) {
    const double side = limb == score::Limb::left_hand ? 0.5 : -0.5;
    const double apart = score::is_hand(limb) ? side * event.apart : 0.0;
    return {event.forward, event.left + apart, 0.0};
}

/// Of a stroke that no body has made.
body::Touch touch_of(const body::KitContact& contact, const score::KitEvent& event) {
    const double speed = score::impact_speed(contact.velocity);
    const double depth = std::pow(1.25 * event.mass * speed * speed / event.stiffness, 0.4);  // [m]
    body::Touch touch;
    touch.instant = contact.time;
    touch.place = place_on(event, contact.limb);
    touch.velocity = {0.0, 0.0, -speed};
    touch.peak_force = {0.0, 0.0, -event.stiffness * std::pow(depth, 1.5)};
    touch.impulse = event.mass * speed * (1.0 + event.elasticity);
    touch.duration = 2.94 * depth / speed;
    touch.effective_mass = event.mass;
    return touch;
}

osc::KitMessage::Pedal pedal_message(const score::Pedal& pedal, const score::Kit& kit) {
    osc::KitMessage::Pedal p;
    p.object = static_cast<int>(pedal.object);
    p.heel = floats<3>(pedal.heel);
    p.length = static_cast<float>(pedal.length);
    p.direction = static_cast<float>(pedal.direction);
    p.down = static_cast<float>(pedal.down);
    p.up = static_cast<float>(pedal.up);
    const Beater beater = beater_of(pedal, kit);
    p.pivot = floats<3>(beater.pivot);
    p.beater_length = static_cast<float>(beater.length);
    p.beater_lean = static_cast<float>(beater.lean);
    return p;
}

}  // namespace

osc::ContactMessage contact_message(const body::KitContact& contact, const score::Kit& kit) {
    const score::KitEvent& event = kit.events[contact.event];
    osc::ContactMessage m;
    m.hand = static_cast<int>(contact.limb);
    m.drum = static_cast<int>(event.object);
    m.stroke = contact.stroke;
    put_touch(contact.touch ? *contact.touch : touch_of(contact, event), m);
    m.event = static_cast<int>(contact.event);
    m.event_name = event.name;
    m.object_name = kit.objects[event.object].name;
    return m;
}

LoggedContact logged_contact(const osc::ContactMessage& m, const body::KitContact& contact) {
    LoggedContact logged;
    sim::ContactEvent& c = logged.event;
    c.hand = m.hand % 2 == 0 ? body::Hand::left : body::Hand::right;
    c.drum = m.drum;
    c.instant = m.instant;
    c.place = {m.place[0], m.place[1], 0.0};
    c.velocity = {m.velocity[0], m.velocity[1], m.velocity[2]};
    c.peak_force = {m.force[0], m.force[1], m.force[2]};
    c.impulse = m.impulse;
    c.duration = m.duration;
    c.effective_mass = m.mass;
    logged.sequence = m.sequence;
    logged.stroke = m.stroke;
    logged.asked_time = contact.time;
    logged.asked_speed = score::impact_speed(contact.velocity);
    return logged;
}

osc::ObjectsMessage objects_message(double time, const body::LiveKit& drummer) {
    osc::ObjectsMessage message;
    message.wall = time;
    int number = 0;
    for (const body::ObjectState& s : drummer.objects()) {
        message.objects.push_back({number++, static_cast<float>(s.flash), floats<3>(s.turn),
                                   static_cast<float>(s.lift), static_cast<float>(s.pedal),
                                   static_cast<float>(s.beater)});
    }
    return message;
}

osc::KitMessage kit_message(double time, const score::Kit& kit) {
    osc::KitMessage message;
    message.wall = time;
    for (const score::KitObject& o : kit.objects) {
        message.objects.push_back(
            {o.name, std::string(score::kObjectKindNames[static_cast<std::size_t>(o.kind)]),
             floats<3>(o.middle), floats(o.orientation()), static_cast<float>(o.radius),
             static_cast<float>(o.depth)});
    }
    for (const score::Pedal& p : kit.pedals) message.pedals.push_back(pedal_message(p, kit));
    for (const score::KitEvent& e : kit.events) {
        message.events.push_back({e.name, static_cast<int>(e.object), static_cast<float>(e.t60)});
    }
    return message;
}

std::vector<osc::StateMessage::Item> pose_items(const body::LiveDrummer& drummer) {
    const auto& shown = drummer.shown();
    if (!shown) return {{"pose", {std::string("off")}}};
    const body::KitPoses& poses = drummer.animation().poses();
    const body::StrikePoses& strike = *poses.of(shown->limb, shown->event);
    std::vector<osc::StateMessage::Item> items{
        {"pose",
         {std::string(name(shown->limb)), drummer.kit().events[shown->event].name,
          std::string(shown->up ? "up" : "down"), strike.off}}};
    const body::LimbPose& pose = shown->up ? strike.up : strike.down;
    for (std::size_t j = 0; j < pose.size(); ++j) {
        const std::string& joint =
            drummer.skeleton().segments[poses.parts(shown->limb).segments[j]].joint;
        const Vector3 angles = body::euler_zyx(pose[j]);
        items.push_back(
            {"joint", {joint.substr(joint.find('_') + 1), angles[0], angles[1], angles[2]}});
    }
    return items;
}

std::optional<body::ShownPose> shown_pose(const osc::ShowPose& wish, const score::Kit& kit) {
    if (wish.limb.empty()) return std::nullopt;
    const auto limb = std::find(score::kLimbNames.begin(), score::kLimbNames.end(), wish.limb);
    const auto event = kit.event_named(wish.event);
    if (!event) throw std::invalid_argument("EVENT: the kit has no '" + wish.event + "'");
    return body::ShownPose{static_cast<score::Limb>(limb - score::kLimbNames.begin()), *event,
                           wish.up};
}

}  // namespace percussionist::app
