// A drummer's body at a whole kit: postures are asked for step by step, muscles drive ODE's bodies
// after them, sticks and feet strike what stands there, and contacts come out.
//
// Each step of h: the posture asked for at t + h, its tips led to where faces will be when they are
// struck (a cymbal still swings, a hi-hat is open) -> the controller's torques -> contacts of both
// tips with every face near, of beaters and cymbals that pedals drive -> ODE steps to t + h. About
// a contact the grip, or the ankle, is loose, and the rebound is the physics' own.
//
// Beside Simulation, which finds its own paths for two sticks at one head, this one is led: by key
// frames or by whatever gives a posture a step ahead. Body, muscles, tips and heads are the same.
//
// One thread; deterministic; step() takes no memory beyond what ODE keeps for itself and
// `contacts`.
#pragma once

#include <array>
#include <vector>

#include "body/inverse_kinematics.hpp"
#include "body/kit_motion.hpp"
#include "body/limb_forecast.hpp"
#include "sim/controller.hpp"
#include "sim/kit_contact.hpp"
#include "sim/kit_pedals.hpp"
#include "sim/kit_surfaces.hpp"
#include "sim/moving_place.hpp"

namespace percussionist::sim {

class KitSimulation {
  public:
    /// `bodies`: what each object is made of, by object; `start`: the time at which it begins [s],
    /// `rate` its steps a second [Hz]. Throws std::invalid_argument.
    KitSimulation(const score::Kit& kit, std::vector<modal::Resonator> bodies,
                  const body::Posture& posture, double start = 0.0, double rate = 1000.0);

    /// The posture that is asked for at time() + step_length().
    void step(const body::Posture& posture, const body::LimbForecasts& forecasts,
              std::vector<KitContact>& contacts);

    [[nodiscard]] double time() const { return start_ + static_cast<double>(steps_) * h_; }
    [[nodiscard]] double step_length() const { return h_; }
    [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }
    /// Where the segments are, and what the kit does; true to the last step.
    [[nodiscard]] const body::Placement& placement() const { return actual_; }
    void kit_state(std::vector<body::ObjectState>& states) const;
    /// Of a stick's tip [m/s].
    [[nodiscard]] double tip_speed(body::Hand hand) const {
        return body_.tip_velocity(hand).norm();
    }
    /// Between a tip and where it was asked to be [m].
    [[nodiscard]] double tip_error(body::Hand hand) const {
        return (body_.tip_position(hand) - target_.placed_now.tip(skeleton_, hand)).norm();
    }
    /// False once the simulation has gone astray (it never should).
    [[nodiscard]] bool sane() const { return body_.sane(); }

  private:
    [[nodiscard]] Vector3 next_face(std::size_t event, const Vector3& spot, double left) const;
    void lead_tips(const body::LimbForecasts& forecasts);
    void mark_contacts(const body::LimbForecasts& forecasts);
    void strike_faces(const body::LimbForecasts& forecasts, std::vector<KitContact>& contacts);
    void press_pedals(std::vector<KitContact>& contacts);
    void tell(score::Limb limb, std::size_t object, const ContactEvent& event,
              std::vector<KitContact>& contacts);

    const score::Kit& kit_;
    double h_, start_;
    std::int64_t steps_ = 0;
    body::Skeleton skeleton_;
    OdeWorld world_;
    OdeBody body_;
    Controller controller_;
    KitPedals pedals_;
    KitSurfaces surfaces_;
    body::InverseKinematics kinematics_;
    std::array<StickTip, 2> tips_;
    std::array<MovingPlace, 2> leads_;       ///< of tips against the posture asked for [m]
    std::array<std::vector<int>, 4> parts_;  ///< segments of each limb
    Target target_;
    body::Placement actual_;
    std::vector<ContactEvent> ended_;
    struct Flash {
        double time = -1e9, height = 0.0;
    };
    std::vector<Flash> flashes_;  ///< by object
};

}  // namespace percussionist::sim
