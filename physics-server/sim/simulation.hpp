// The percussionist at the drum: what is asked for (strokes), what is simulated (body, sticks,
// head), what comes out (contacts, poses).
//
// Each step of h: the paths of both tips at t + h -> inverse kinematics -> targets at t + h; the
// controller drives ODE's bodies by the targets at t - h, t and t + h; where a stick is near the
// head the contact is sub-integrated at audio rate and its mean force applied; ODE steps to t + h.
//
// One thread. The same calls give the same results, to the last bit. step() takes no memory beyond
// what ODE keeps for itself. Time is simulated time [s], from 0.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "body/inverse_dynamics.hpp"
#include "body/inverse_kinematics.hpp"
#include "body/posture.hpp"
#include "body/stroke_path.hpp"
#include "sim/contact_event.hpp"
#include "sim/controller.hpp"
#include "sim/drumhead.hpp"
#include "sim/impact_forecast.hpp"
#include "sim/ode_body.hpp"

namespace percussionist::sim {

struct SimulationOptions {
    double rate = 1000.0;  ///< steps a second of simulated time, 250 to 4000 [Hz]
    body::Anthropometry person;
    ControlOptions control;
    DrumheadOptions head;
    double head_height = 0.92;    ///< of the head above the floor [m]
    double strike_radius = 0.75;  ///< where the sticks meet the head, share of its radius
    double strikes_apart = 0.16;  ///< distance between the places of both sticks [m]
};

class Simulation {
  public:
    /// Throws std::invalid_argument naming the option that is out of range.
    explicit Simulation(const SimulationOptions& options);

    /// A step of h; contacts that ended in it are appended to `contacts`.
    void step(std::vector<ContactEvent>& contacts);

    [[nodiscard]] double time() const { return static_cast<double>(steps_) * h_; }
    [[nodiscard]] double step_length() const { return h_; }
    /// The earliest time for which something can still be asked: targets up to now are made.
    [[nodiscard]] double frontier() const { return time() + h_; }

    /// Asks for a stroke; see body::StrokePath::aim. The rebound is forecast here.
    bool strike(body::Hand hand, double time, double speed, double height);
    void rest(body::Hand hand) { own_path(hand).rest(frontier()); }
    [[nodiscard]] const body::StrokePath& path(body::Hand hand) const {
        return paths_[static_cast<int>(hand)];
    }

    [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }
    /// Where the segments are; true to the last step.
    [[nodiscard]] const body::Placement& placement() const { return actual_; }
    /// The middle of a tip against the point of the head it strikes, world axes: z 0 at the touch.
    [[nodiscard]] Vector3 tip(body::Hand hand) const;
    /// Where the target has it.
    [[nodiscard]] Vector3 tip_target(body::Hand hand) const;
    /// The head's middle, world [m].
    [[nodiscard]] const Vector3& head_centre() const { return head_centre_; }
    /// False once the simulation has gone astray (it never should).
    [[nodiscard]] bool sane() const { return body_->sane(); }

  private:
    body::StrokePath& own_path(body::Hand hand) { return paths_[static_cast<int>(hand)]; }
    [[nodiscard]] body::ArmTarget arm_target(body::Hand hand, double t) const;
    void fill_target(double t);
    void mark_contacts();
    TouchingTip touching_tip(body::Hand hand);

    SimulationOptions options_;
    double h_;
    std::int64_t steps_ = 0;
    body::Skeleton skeleton_;
    OdeWorld world_;
    std::unique_ptr<OdeBody> body_;
    std::unique_ptr<Controller> controller_;
    std::unique_ptr<Drumhead> head_;
    std::unique_ptr<ImpactForecast> forecast_;
    body::InverseKinematics kinematics_;
    std::array<body::TipMass, 2> tip_mass_;
    std::array<body::StrokePath, 2> paths_;
    std::array<Vector3, 2> places_;  ///< where each stick meets the head, world [m]
    std::array<Vector3, 2> last_velocity_;
    std::array<double, 2> last_impulse_{};
    Vector3 head_centre_;
    Target target_;
    body::Posture solution_;
    body::Placement solved_, actual_;
    std::vector<double> bare_;  ///< no resistance: the mass of the body alone
};

}  // namespace percussionist::sim
