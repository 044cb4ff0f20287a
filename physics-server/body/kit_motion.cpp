#include "body/kit_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percussionist::body {

namespace {

constexpr double kSwingTime = 0.9;     // [s]
constexpr double kSwingRate = 1.3;     // [Hz]
constexpr double kLargest = 0.22;      // of the loudest stroke at the edge [rad]
constexpr double kOnlyCymbals = 0.25;  // of it, of what is held by a stand's clutch

const std::complex<double> kSwing(-1.0 / kSwingTime, 2.0 * std::numbers::pi * kSwingRate);

}  // namespace

KitMotion::KitMotion(const score::Kit& kit, std::span<const score::KitStroke> strokes)
    : kit_(kit), struck_(kit.objects.size()) {
    for (const score::KitStroke& stroke : strokes) strike(stroke);
}

void KitMotion::strike(const score::KitStroke& stroke) {
    const score::KitEvent& event = kit_.events[stroke.event];
    const score::KitObject& object = kit_.objects[event.object];
    auto& list = struck_[event.object];
    Struck now{stroke.time, stroke.velocity, {}};
    if (!list.empty()) {
        const double since = stroke.time - list.back().time;
        now.flash += list.back().flash * std::exp(-since / kFlashTime);
        now.flash = std::min(now.flash, 1.0);
        for (int a = 0; a < 2; ++a) now.swing[a] = list.back().swing[a] * std::exp(since * kSwing);
    }
    const bool swings = object.kind == score::ObjectKind::cymbal;
    const bool clutched = object.kind == score::ObjectKind::hi_hat && !event.foot;
    if (swings || clutched) {
        const double push =
            (swings ? 1.0 : kOnlyCymbals) * kLargest * stroke.velocity / object.radius;
        // The side that is struck goes down.
        now.swing[0] -= push * event.left;
        now.swing[1] += push * event.forward;
    }
    list.push_back(now);
}

void KitMotion::forget() {
    for (auto& list : struck_) {
        if (list.size() > 1) list.erase(list.begin(), list.end() - 1);
    }
}

void KitMotion::at(double t, const Skeleton& skeleton, const Placement& placement,
                   std::vector<ObjectState>& states) const {
    states.assign(kit_.objects.size(), {});
    for (std::size_t o = 0; o < struck_.size(); ++o) {
        const auto& list = struck_[o];
        const auto next =
            std::upper_bound(list.begin(), list.end(), t,
                             [](double time, const Struck& s) { return time < s.time; });
        if (next == list.begin()) continue;
        const Struck& last = *(next - 1);
        const double since = t - last.time;
        const std::complex<double> turned = std::exp(since * kSwing);
        states[o].flash = last.flash * std::exp(-since / kFlashTime);
        states[o].turn =
            kit_.objects[o].orientation() *
            Vector3((last.swing[0] * turned).imag(), (last.swing[1] * turned).imag(), 0.0);
    }
    for (const score::Pedal& pedal : kit_.pedals) {
        ObjectState& state = states[pedal.object];
        state.pedal = pedal_up(skeleton, placement, pedal);
        if (kit_.objects[pedal.object].kind == score::ObjectKind::hi_hat) {
            state.lift = score::kHatOpens * state.pedal;
        } else {
            state.beater = kBeaterTurns * state.pedal;
        }
    }
}

}  // namespace percussionist::body
