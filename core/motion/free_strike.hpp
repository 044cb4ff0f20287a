// Strikes on nothing: told from the movement alone, wherever in space it is made.
//
// A hand that swings moves smoothly: what a parabola through the way in foretells for the way out,
// comes. At a strike it does not: within a contact's time the velocity jumps, and turns back. So at
// each point the last few (way out) and some before (way in), a gap of up to `longest_contact`
// between them, are fitted, and it is a strike where
//  - the way in ends with `least_speed` or more,
//  - the way out has lost `turned` of that velocity or more, in its direction,
//  - the deceleration in the gap is `sharpness` times what both ways show along the same line (a
//    swing's turn at the top is as smooth as the swing), and
//  - it is `least_deceleration` or more, and where it opposes a strike just before, more than that,
//  - the way out is not faster than the way in: the head gives nothing that it was not given,
//  - the jump stands out of the noise by `certainty`; noise is how far points lie from fits of the
//    way in, now or lately, whichever is more.
// Told are the turning point (the path's end along the jump: where both ways meet, or in a longer
// contact the vertex of the points in it) and the instant of greatest deceleration. It is known
// about three records after the turn; with records further apart than 20 ms not at all.
//
// Follows Marshall, Moynihan, Rath 2002, "The Vodhran", 5: changes in velocity, changes in
// direction and local minima of movement curves. Pure; real-time safe; one detector for each tip.
#pragma once

#include <optional>

#include "core/motion/local_fit.hpp"
#include "core/motion/recent.hpp"

namespace percussionist::motion {

struct FreeStrikeSettings {
    double least_speed = 0.4;       ///< of the way in [m/s]
    double longest_contact = 0.06;  ///< from the way in to the way out [s]
    double turned = 0.9;            ///< part of the velocity that is lost; above 1: it comes back
    double least_deceleration = 40.0;  ///< mean, in the gap [m/s^2]
    double sharpness = 2.5;            ///< deceleration in the gap over that beside it
    double certainty = 8.0;            ///< jump of the velocity over its own uncertainty
    double swing = 0.3;  ///< after a strike, so long, a turn the other way has to be harder [s]
    double rest = 0.06;  ///< between strikes at least [s]
};

struct FreeStrike {
    double time = 0.0;                     ///< of the turning point [s]
    double peak_time = 0.0;                ///< of the greatest deceleration [s]
    double speed = 0.0;                    ///< of the way in, at its end [m/s]
    double deceleration = 0.0;             ///< mean, in the gap [m/s^2]
    Vector3 direction = Vector3::UnitX();  ///< of the way in
    Vector3 place = Vector3::Zero();       ///< of the turning point [m]
};

class FreeStrikeDetector {
  public:
    explicit FreeStrikeDetector(const FreeStrikeSettings& settings) : settings_(settings) {}

    std::optional<FreeStrike> add(const PathPoint& tip) noexcept;
    void reset() noexcept { points_.clear(); }
    void set(const FreeStrikeSettings& settings) { settings_ = settings; }

  private:
    bool is_swing_back(const Vector3& away, double deceleration) const noexcept;
    double noise() noexcept;
    std::optional<FreeStrike> judge(std::size_t gap, double noise) const noexcept;
    void locate(FreeStrike& strike, const LocalFit& in, const LocalFit& out, const Vector3& away,
                std::size_t gap) const noexcept;

    FreeStrikeSettings settings_;
    Recent<PathPoint, 20> points_;
    Recent<double, 32> residuals_;
    FreeStrike last_{.time = -1e9};
};

}  // namespace percussionist::motion
