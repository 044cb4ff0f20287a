// A contact of a limb with an object of a kit, whether it was asked for or not; and what note it
// is.
#pragma once

#include <cstddef>
#include <optional>

#include "core/score/kit.hpp"
#include "sim/contact_event.hpp"

namespace percussionist::sim {

/// Places and velocities are in the frame of the face; of a foot, those of the beater or cymbal.
struct KitContact {
    score::Limb limb = score::Limb::right_hand;
    std::size_t object = 0;
    ContactEvent contact;
};

/// Late by so much [s] (early below 0) is a stroke; farther off no contact is its own.
inline constexpr double kOwnContact = 0.040;

/// The first event with which this limb strikes the object; the first of all if there is none.
std::size_t event_of(const score::Kit& kit, const KitContact& contact);

/// Of the note, 0..1, whose striker has the same momentum at that event; none where nothing struck.
std::optional<double> note_velocity(const score::KitEvent& event, const KitContact& contact);

}  // namespace percussionist::sim
