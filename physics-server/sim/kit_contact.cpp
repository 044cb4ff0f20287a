#include "sim/kit_contact.hpp"

#include <algorithm>

#include "core/score/stroke_plan.hpp"

namespace percussionist::sim {

std::size_t event_of(const score::Kit& kit, const KitContact& contact) {
    for (std::size_t e = 0; e < kit.events.size(); ++e) {
        const score::KitEvent& event = kit.events[e];
        const bool own = event.foot ? *event.foot == contact.limb : score::is_hand(contact.limb);
        if (own && event.object == contact.object) return e;
    }
    return 0;
}

std::optional<double> note_velocity(const score::KitEvent& event, const KitContact& contact) {
    constexpr double kFastest = 6.0;  // that is heard [m/s]
    const double momentum = -contact.contact.velocity.z() * contact.contact.effective_mass;
    if (momentum <= 0.0) return std::nullopt;
    return score::velocity_of_impact(std::min(kFastest, momentum / event.mass));
}

}  // namespace percussionist::sim
