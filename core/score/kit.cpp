#include "core/score/kit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percussionist::score {

namespace {

constexpr std::size_t kMostThings = 256;

void expect(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("kit: " + what);
}

void check_range(double value, double low, double high, const std::string& what) {
    if (value >= low && value <= high) return;
    expect(false, what + ": expected " + std::to_string(low) + " to " + std::to_string(high) +
                      ", got " + std::to_string(value));
}

template <class Things>
std::optional<std::size_t> named(const Things& things, std::string_view name) {
    const auto found =
        std::find_if(things.begin(), things.end(), [&](const auto& t) { return t.name == name; });
    if (found == things.end()) return std::nullopt;
    return static_cast<std::size_t>(found - things.begin());
}

void check_drummer(const Drummer& d) {
    check_range(d.stature, 0.5, 2.5, "the drummer's stature [m]");
    check_range(d.mass, 10.0, 300.0, "the drummer's mass [kg]");
    check_range(d.hips, 0.1, 1.5, "the height of the hips [m]");
    check_range(d.stick_length, 0.1, 1.0, "the stick's length [m]");
    check_range(d.stick_held, 0.0, 0.5 * d.stick_length, "where the stick is held [m]");
    check_range(d.stick_mass, 0.001, 1.0, "the stick's mass [kg]");
    check_range(d.rise, 0.02, 1.0, "how far the stick is raised [m]");
}

void check_limits(const LimbLimits& l) {
    check_range(l.bounce, 0.001, 10.0, "the time of a bounce [s]");
    check_range(l.interval, l.bounce, 10.0, "the interval of a hand [s]");
    check_range(l.foot, 0.001, 10.0, "the interval of a foot [s]");
    check_range(l.settling, 0.0, l.interval, "the settling of a hand [s]");
    check_range(l.speed, 0.1, 100.0, "the speed of a hand [m/s]");
}

void check_object(const KitObject& o) {
    for (const double c : o.middle) check_range(c, -3.0, 3.0, o.name + ": its place [m]");
    check_range(o.radius, 0.01, 1.0, o.name + ": its radius [m]");
    check_range(o.depth, 0.0, 1.0, o.name + ": its depth [m]");
    check_range(o.level, 0.0, 100.0, o.name + ": its level");
    check_range(o.wires, 0.0, 100.0, o.name + ": its wires");
    check_range(o.lean_back, -1.6, 1.6, o.name + ": its lean back [rad]");
    check_range(o.lean_left, -1.6, 1.6, o.name + ": its lean to the left [rad]");
}

void check_event(const Kit& kit, const KitEvent& e) {
    expect(e.object < kit.objects.size(), e.name + ": no such object");
    const double out = std::hypot(e.forward, e.left) + 0.5 * e.apart;
    check_range(out, 0.0, kit.objects[e.object].radius, e.name + ": distance from the middle [m]");
    check_range(e.elasticity, 0.0, 1.0, e.name + ": its elasticity");
    check_range(e.mass, 1e-4, 10.0, e.name + ": the striker's mass [kg]");
    check_range(e.stiffness, 1.0, 1e12, e.name + ": the striker's stiffness");
    check_range(e.t60, 0.0, 100.0, e.name + ": its t60 [s]");
    expect(!e.hand || is_hand(*e.hand), e.name + ": expected a hand");
    expect(!e.foot || (!is_hand(*e.foot) && kit.pedal_of(*e.foot) != nullptr),
           e.name + ": expected a foot that has a pedal");
}

void check_pedal(const Kit& kit, const Pedal& p) {
    expect(p.object < kit.objects.size(), "a pedal of no object");
    const std::string what = kit.objects[p.object].name + "'s pedal";
    expect(!is_hand(p.foot), what + ": expected a foot");
    for (const double c : p.heel) check_range(c, -3.0, 3.0, what + ": its heel [m]");
    check_range(p.length, 0.05, 0.6, what + ": its length [m]");
    check_range(p.direction, -1.6, 1.6, what + ": its direction [rad]");
    check_range(p.down, -0.2, 1.0, what + ": its angle down [rad]");
    check_range(p.up, p.down, 1.2, what + ": its angle up [rad]");
}

void check_script(const Script& s) {
    const std::string what = "script of " + s.joint;
    expect(s.curve.size() >= 2 && s.curve.size() <= 100, what + ": expected 2 to 100 numbers");
    expect(s.curve.front() == 0.0 && s.curve.back() == 1.0, what + ": expected 0 first, 1 last");
    for (const double share : s.curve) check_range(share, -1.0, 2.0, what);
}

}  // namespace

linear::Quaternion KitObject::orientation() const {
    return linear::Quaternion(Eigen::AngleAxisd(-lean_back, Vector3::UnitY()) *
                              Eigen::AngleAxisd(-lean_left, Vector3::UnitX()));
}

std::optional<std::size_t> Kit::object_named(std::string_view wanted) const {
    return named(objects, wanted);
}

std::optional<std::size_t> Kit::event_named(std::string_view wanted) const {
    return named(events, wanted);
}

const Pedal* Kit::pedal_of(Limb foot) const {
    const auto found = std::find_if(pedals.begin(), pedals.end(),
                                    [foot](const Pedal& p) { return p.foot == foot; });
    return found == pedals.end() ? nullptr : &*found;
}

Vector3 spot_of(const Kit& kit, std::size_t event, Limb hand) {
    const KitEvent& e = kit.events[event];
    const double side = hand == Limb::left_hand ? 0.5 : -0.5;
    const KitObject& object = kit.objects[e.object];
    const double lift = e.hat == HatState::open ? kOpenHat * kHatOpens : 0.0;
    return object.middle + object.orientation() * Vector3(e.forward, e.left + side * e.apart, lift);
}

void check(const Kit& kit) {
    check_drummer(kit.drummer);
    check_limits(kit.limits);
    expect(!kit.objects.empty() && kit.objects.size() <= kMostThings, "expected 1 to 256 objects");
    expect(!kit.events.empty() && kit.events.size() <= kMostThings, "expected 1 to 256 events");
    for (const KitObject& o : kit.objects) check_object(o);
    for (const Pedal& p : kit.pedals) check_pedal(kit, p);
    for (const KitEvent& e : kit.events) check_event(kit, e);
    for (const int event : kit.keys) {
        expect(event == kNotOfTheKit || (event >= 0 && event < static_cast<int>(kit.events.size())),
               "a key of no event");
    }
    expect(kit.pairs.size() == kit.events.size() * kit.events.size(),
           "expected a preference, or none, for each pair of events");
    for (const Script& s : kit.scripts) check_script(s);
    for (const PoseEdit& p : kit.poses) expect(p.event < kit.events.size(), "a pose of no event");
}

}  // namespace percussionist::score
