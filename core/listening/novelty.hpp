// How suddenly a signal rises: every rise that might be a stroke shows, and many that are none.
//
// Measured in the short window's bands, low, middle and high ones apart, and in all together: how
// much each band is above the loudest it was 10 to 20 ms ago, in nats, the best group counting.
// What lies far below the usual level of its band is not heard: the logarithm of nearly nothing
// jumps. Which of the rises were drums is for the classifier to say.
// Source: Boeck, Widmer 2013 (spectral flux in logarithms with a maximum over the past).
//
// push() does not allocate, lock or throw.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/listening/band_analyser.hpp"
#include "core/listening/hearing.hpp"

namespace percussionist::listening {

class Novelty {
  public:
    Novelty() { reset(); }

    /// Above it something may have been struck.
    static constexpr float kThreshold = 0.7F;

    float push(const BandFrame& frame, const Hearing& hearing) noexcept;
    /// Before the first frame is silence.
    void reset() noexcept;

  private:
    static constexpr std::size_t kKept = 5;
    std::array<std::array<float, kQuick>, kKept> past_{};
    std::size_t count_ = 0;
};

/// A moment where something may have been struck.
struct Attack {
    std::size_t frame = 0;  ///< where the rise is steepest
    float within = 0.0F;    ///< of a frame, -0.5 to 0.5: the peak, between frames
    float strength = 0.0F;  ///< novelty
};

/// The peaks of a whole recording's novelty, each the highest within 25 ms either way.
std::vector<Attack> attacks(std::span<const float> novelty);

/// Where a parabola through three values has its peak, from the middle one.
float peak_between(float before, float at, float after) noexcept;

}  // namespace percussionist::listening
