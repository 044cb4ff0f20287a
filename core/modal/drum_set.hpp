// Drums of the usual sizes, out of what they are made of: computed, none of them measured.
//
// Sizes are those drums are sold in, tensions such that the lowest mode lies where such drums are
// tuned, densities and stiffnesses those of the usual skins (Mylar of 0.19 to 0.25 mm, goat skin,
// bronze). Losses are our choice, to the ear of the drums' usual ringing. Allocates.
#pragma once

#include <span>
#include <string>

#include "core/modal/resonator.hpp"

namespace percussionist::modal {

struct DrumOfSet {
    std::string name;
    std::string what;  ///< one line
    Body body;
    Loss loss;
};

std::span<const DrumOfSet> drum_set();

/// Throws std::invalid_argument listing the names there are.
const DrumOfSet& drum_of_set(const std::string& name);

/// A round body's lowest modes as a mode file has them, at 21 places; what is heard is the pressure
/// a metre away, 0.6 rad off the axis.
GivenModes computed_modes(const DrumOfSet& drum, std::size_t count);

}  // namespace percussionist::modal
