#include "sim/simulated_drummer.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::sim {

namespace {

/// A contact is known by then, after what asked for it [s].
constexpr double kKnown = 0.1;

}  // namespace

SimulatedDrummer::SimulatedDrummer(body::LiveDrummer& led, std::vector<modal::Resonator> bodies)
    : led_(led), bodies_(std::move(bodies)) {
    begin(0.0);
}

void SimulatedDrummer::begin(double now) {
    body_ = std::make_unique<KitSimulation>(led_.kit(), bodies_, led_.posture(), now, 1.0 / kStep);
    body_->kit_state(objects_);
}

void SimulatedDrummer::load(std::vector<score::KitStroke> strokes) {
    led_.load(std::move(strokes));
    // Of the plan before; what they ask for is still under way.
    for (Asked& asked : asked_) asked.stroke.stroke = -1;
}

void SimulatedDrummer::step(double now, const score::SongStep& song) {
    led_.step(now, song);
    const body::LimbForecasts forecasts = led_.forecasts();
    body_->step(led_.posture(), forecasts, made_);
    if (!body_->sane()) begin(now);
    ask(now);
    contacts_.clear();
    std::erase_if(made_, [&](const KitContact& made) { return tell(made, forecasts); });
    body_->kit_state(objects_);
}

void SimulatedDrummer::ask(double now) {
    for (const body::KitContact& stroke : led_.contacts()) asked_.push_back({stroke});
    std::erase_if(asked_, [&](const Asked& asked) {
        const bool over = asked.stroke.time < now - kKnown;
        if (over && !asked.made && asked.stroke.stroke >= 0) ++missed_;
        return over;
    });
}

/// False for one that may be of a stroke which is yet to come.
bool SimulatedDrummer::tell(const KitContact& made, const body::LimbForecasts& forecasts) {
    const double instant = made.contact.instant;
    const auto off = [&](const Asked& asked) { return std::abs(asked.stroke.time - instant); };
    const auto strikes = [&](std::size_t event) {
        return led_.kit().events[event].object == made.object;
    };
    Asked* own = nullptr;
    for (Asked& asked : asked_) {
        const body::KitContact& stroke = asked.stroke;
        if (asked.made || stroke.limb != made.limb || !strikes(stroke.event)) continue;
        if (off(asked) < (own != nullptr ? off(*own) : kOwnContact)) own = &asked;
    }
    if (own != nullptr) {
        own->made = true;
        contacts_.push_back(own->stroke);
        contacts_.back().touch = made.contact;
        return true;
    }
    const body::LimbForecast& f = forecasts[score::index(made.limb)];
    if (strikes(f.next.event) && f.next.time - instant < kOwnContact) return false;
    const std::size_t event = strikes(f.last.event) ? f.last.event : event_of(led_.kit(), made);
    if (const auto velocity = note_velocity(led_.kit().events[event], made)) {
        contacts_.push_back({instant, made.limb, event, *velocity, -1, false, made.contact});
    }
    return true;
}

}  // namespace percussionist::sim
