// Pedals: plates on hinges, held up by springs, that feet press down, each with what it drives by a
// rod: a beater that falls on a drum's head, or the upper cymbal of a hi-hat that falls on the
// lower.
//
// A plate's angle is the one degree of freedom; beater (arm 0.2 m, a radian of way) or cymbal are
// geared to it, and their inertia is felt at its hinge. Where the beater is near its head, or the
// cymbal near the other, the contact is integrated finely as that of a stick (Drumhead). The foot
// presses from above: ODE's contact joint between sole and plate, soft, without friction.
//
// The constructor allocates; step by step ODE alone does. One thread; deterministic.
#pragma once

#include <memory>
#include <vector>

#include "body/drummer.hpp"
#include "core/score/kit.hpp"
#include "sim/controller.hpp"
#include "sim/drumhead.hpp"
#include "sim/ode_body.hpp"

namespace percussionist::sim {

class KitPedals {
  public:
    /// `bodies`: what each object of the kit is made of. Throws std::invalid_argument.
    KitPedals(const score::Kit& kit, const std::vector<modal::Resonator>& bodies, OdeWorld& world,
              double h);
    ~KitPedals();
    KitPedals(const KitPedals&) = delete;
    KitPedals& operator=(const KitPedals&) = delete;

    [[nodiscard]] std::size_t size() const { return plates_.size(); }
    [[nodiscard]] const score::Pedal& pedal(std::size_t i) const { return kit_.pedals[i]; }
    /// Let go: 0 pressed, 1 up; and its rate [1/s].
    [[nodiscard]] double up(std::size_t i) const;
    [[nodiscard]] double rate(std::size_t i) const;
    /// What legs have to exert on their plates so that these go with the feet as `target` has them,
    /// added to their joints for the step to come.
    void support(const Target& target, OdeBody& body) const;
    /// Forces for the step from `time` to time + h: of springs, feet and what is driven. Contacts
    /// that have ended are appended, `drum` being the object; slower than 3 cm/s they are none.
    void apply(double time, const OdeBody& body, const body::Placement& actual,
               std::vector<ContactEvent>& contacts);

  private:
    struct Plate {
        dBodyID body = nullptr;
        dJointID hinge = nullptr;
        std::vector<int> leg;  ///< segments, the foot last
        double inertia = 0.0;  ///< about the hinge, with what it drives [kg m^2]
        double gear = 0.0;     ///< of what it drives, way by angle [m]
        double last_rate = 0.0, last_torque = 0.0;  ///< of the contact, a step before
        std::unique_ptr<Drumhead> head;
    };
    void make(std::size_t i, const modal::Resonator& body, OdeWorld& world);
    void press(const Plate& plate, const score::Pedal& pedal, const OdeBody& body,
               const body::Placement& actual);
    void drive(std::size_t i, double time, std::vector<ContactEvent>& contacts);
    [[nodiscard]] bool hat(std::size_t i) const;
    /// Above where it is pressed [rad].
    [[nodiscard]] double angle(const Plate& plate) const;
    [[nodiscard]] double angle_rate(const Plate& plate) const;

    const score::Kit& kit_;
    OdeWorld& world_;
    double h_;
    dJointGroupID touching_;
    std::vector<Plate> plates_;
};

}  // namespace percussionist::sim
