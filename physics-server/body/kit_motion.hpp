// What the kit itself does: cymbals swing when struck, heads flash, pedals and hi-hat follow feet.
//
// A cymbal on its stand is a damped pendulum about either axis of its face: each stroke gives it a
// turning impulse by its velocity and its distance from the middle, and swings add up,
//     angle = amplitude exp(-t / tau) sin(2 pi f t).
// A flash is the velocity, fading in 80 ms. Frequency, decay and amplitude are our choice.
//
// The constructor allocates; at() does not once `states` has its size. Any thread.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "body/drummer.hpp"
#include "core/score/kit_plan.hpp"

namespace percussionist::body {

inline constexpr double kBeaterTurns = 1.0;  ///< with the pedal up [rad]
inline constexpr double kFlashTime = 0.08;   ///< [s]

struct ObjectState {
    Vector3 turn = Vector3::Zero();  ///< about its middle, world, rotation vector [rad]
    double lift = 0.0;               ///< of the hi-hat's upper cymbal [m]
    double flash = 0.0;              ///< 0 to 1
    double pedal = 0.0;              ///< let go: 0 pressed, 1 up; of what has a pedal
    double beater = 0.0;             ///< of a drum's pedal, turned back from the head [rad]
};

class KitMotion {
  public:
    KitMotion(const score::Kit& kit, std::span<const score::KitStroke> strokes);

    /// One more, not before any other.
    void strike(const score::KitStroke& stroke);
    /// Of each object's strokes all but the last are forgotten: the past cannot be asked for.
    void forget();

    /// By object; `placement` is that of the drummer at the same time t [s].
    void at(double t, const Skeleton& skeleton, const Placement& placement,
            std::vector<ObjectState>& states) const;

  private:
    /// What a stroke leaves an object with.
    struct Struck {
        double time;                                ///< [s]
        double flash;                               ///< 0 to 1
        std::array<std::complex<double>, 2> swing;  ///< about the face's x and y [rad]
    };
    const score::Kit& kit_;
    std::vector<std::vector<Struck>> struck_;  ///< by object
};

}  // namespace percussionist::body
