// Whether bytes are an OSC packet, to the last one. What passes here, oscpack reads without
// looking beyond the end of anything.
#pragma once

#include <cstdint>
#include <span>

namespace percussionist::io {

/// Throws MalformedOsc.
void check_osc(std::span<const std::uint8_t> packet);

}  // namespace percussionist::io
