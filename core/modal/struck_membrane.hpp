// A struck membrane, of so many modes: the head the simulated sticks fall on. See struck_head.hpp.
#pragma once

#include "core/modal/struck_head.hpp"

namespace percussionist::modal {

class StruckMembrane : public StruckHead {
  public:
    /// Throws std::invalid_argument.
    StruckMembrane(const Membrane& membrane, const Loss& loss, std::size_t mode_count,
                   double sample_rate)
        : StruckHead(Resonator(membrane, loss, {.count = mode_count}), sample_rate) {}

    /// Another membrane or decay while it sounds: nothing clicks. Throws std::invalid_argument and
    /// then changes nothing.
    void tune(const Membrane& membrane, const Loss& loss) { retune(membrane, loss); }
};

}  // namespace percussionist::modal
