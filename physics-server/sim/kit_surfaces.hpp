// The things of a kit that sticks strike: drums, bells and the hi-hat's upper cymbal where they
// stand, cymbals hung on their stands as bodies of ODE. Each is a Drumhead of what it is made of.
//
// A cymbal is a disc on a ball joint with a spring and a damper, f = 1.3 Hz, tau = 0.4 s; struck
// off its middle it swings by its own inertia. An event's elasticity is a fact of its contact: the
// share of its speed with which a stick comes back from there, had by the felt's dissipation, as
// far as what is struck allows.
//
// The constructor allocates and takes a part of a second. One thread; deterministic.
#pragma once

#include <memory>
#include <vector>

#include "core/score/kit.hpp"
#include "sim/stick_tip.hpp"

namespace percussionist::sim {

class KitSurfaces {
  public:
    /// `bodies`: what each object is made of. Throws std::invalid_argument.
    KitSurfaces(const score::Kit& kit, std::vector<modal::Resonator> bodies, OdeWorld& world,
                double h);

    [[nodiscard]] std::size_t size() const { return heads_.size(); }
    [[nodiscard]] Drumhead& head(std::size_t object) { return *heads_[object]; }
    /// Where a hand strikes it now; the hi-hat is lifted by `lift` [m], and faster by `rate` [m/s].
    [[nodiscard]] Face face(std::size_t object) const;
    void lift(std::size_t object, double height, double rate) { lifts_[object] = {height, rate}; }
    /// How far the place (of the object at rest, world) will have moved within `time` [s], if
    /// nothing else strikes it [m].
    [[nodiscard]] Vector3 moved(std::size_t object, const Vector3& place, double time) const;
    /// Of a cymbal against how it hangs at rest, rotation vector, world [rad].
    [[nodiscard]] Vector3 swing(std::size_t object) const;
    /// An impulse at a place [N s, world] for the step to come.
    void push(std::size_t object, const Vector3& place, const Vector3& impulse);
    /// Springs and dampers for the step to come.
    void apply();
    /// With which a stick strikes an event.
    [[nodiscard]] const modal::Mallet& felt(std::size_t event) const { return felts_[event]; }

  private:
    struct Lift {
        double height = 0.0, rate = 0.0;
    };
    struct Hung {
        dBodyID body = nullptr;  ///< null: it stands
        dJointID motor = nullptr;
        double inertia = 0.0;  ///< about an axis in its face [kg m^2]
    };
    void hang(std::size_t object, OdeWorld& world);
    void find_felts(const std::vector<modal::Resonator>& bodies, double rate);

    const score::Kit& kit_;
    double h_;
    std::vector<std::unique_ptr<Drumhead>> heads_;
    std::vector<Hung> hung_;
    std::vector<Lift> lifts_;
    std::vector<modal::Mallet> felts_;  ///< by event
};

}  // namespace percussionist::sim
