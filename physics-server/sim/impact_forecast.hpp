// What the head will do with a stick: speed and time of its rebound, found by letting a free mass
// fall on it beforehand.
//
// A target that knows this leaves the controller nothing to fight while stick and head decide.
// Construction takes some milliseconds; reading is pure and real-time safe.
#pragma once

#include <array>

#include "body/stroke_path.hpp"
#include "sim/drumhead.hpp"

namespace percussionist::sim {

class ImpactForecast {
  public:
    /// A tip of `mass` [kg] that falls at `place` of a head at rest. Throws std::invalid_argument.
    ImpactForecast(const DrumheadOptions& options, double h, double mass,
                   const linear::Vector3& place);

    /// For an impact speed [m/s], interpolated; beyond the table its last entry, scaled.
    [[nodiscard]] body::Rebound rebound(double speed) const;

  private:
    static constexpr int kSpeeds = 24;
    static constexpr double kStep = 0.5;  ///< between two speeds of the table [m/s]
    std::array<body::Rebound, kSpeeds> table_;
};

}  // namespace percussionist::sim
