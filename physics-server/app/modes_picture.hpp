// The picture of measured modes: what was recorded, what was found in it.
#pragma once

#include <span>
#include <string>

#include "core/modal/modes_of_hits.hpp"

namespace percussionist::app {

/// Spectrum of the loudest recording with the modes' stems; decays; weights over the places.
/// Throws std::runtime_error if the file cannot be written.
void draw_modes(const std::string& path, const modal::MeasuredModes& measured,
                std::span<const modal::Hit> hits, double rate);

}  // namespace percussionist::app
