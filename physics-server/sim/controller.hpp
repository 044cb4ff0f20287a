// The muscles: what turns a target posture into torques.
//
// Ours is a proportional-derivative law solved implicitly by ODE together with the joints,
//     tau = kp e(t + h) + kd (w_target - w)(t + h),
// as an angular motor with CFM = 1 / (h kp + kd) and velocity kp e / (h kp + kd) + w_target: exact,
// and stable at any gain. Gains come from the inertia of what hangs on the joint:
// kp = I (2 pi f)^2, kd = 2 I 2 pi f (critical damping). To it is added the torque that inverse
// dynamics forecasts, so that the gain has only errors to mend. Targets are held to the limits of
// their joints; a joint that is beyond them is brought back by a stop that no torque limit weakens.
//
// The law of the papers (Bouenard, Gibet, Wanderley 2009, equation 1), tau = ks e - kd w applied
// explicitly, is kept to compare with. Applied so it is stable only up to gains that the lighter
// side of each joint stands in a step (a clavicle's twist has 1e-4 kg m^2); beyond, they are held
// there.
#pragma once

#include <array>
#include <vector>

#include "body/inverse_dynamics.hpp"
#include "body/posture.hpp"
#include "sim/ode_body.hpp"

namespace percussionist::sim {

enum class Law { implicit, paper };

struct ControlOptions {
    Law law = Law::implicit;
    double frequency = 40.0;         ///< of every joint but the grip [Hz]
    double grip_frequency = 40.0;    ///< of the grip in free air [Hz]
    double contact_frequency = 6.0;  ///< of a loose joint, the grip about a contact [Hz]
    double damping = 1.0;            ///< of every joint; 1: critical
    double paper_frequency = 5.0;    ///< of every joint under the law of the papers [Hz]
    double paper_damping = 1.0;      ///< and its damping
};

/// The motion asked for: the targets one step before, at and one step after the present.
struct Target {
    body::Posture before, now, after;
    body::Placement placed_before, placed_now, placed_after;
    /// By segment, whether it strikes now: then its path bends by the force of what is struck, not
    /// by the muscles', and the forecast of its acceleration holds its last value.
    std::vector<char> strikes;
    std::vector<char> loose;  ///< by segment: whether its joint is to be loose
    explicit Target(const body::Skeleton& skeleton);
    /// Moves on by a step: now becomes before, after becomes now; after is to be filled anew.
    void advance();
};

class Controller {
  public:
    Controller(OdeBody& body, const ControlOptions& options, double h);

    /// Sets motors and adds torques for the step to come. No allocation.
    void apply(const Target& target);

    /// How much each joint resists an impulse within the coming step, h kd + h^2 kp [kg m^2].
    [[nodiscard]] const std::vector<double>& resistance() const { return resistance_; }

    // All of these may be called between two steps. Throws std::invalid_argument.
    /// Takes over the masses of the skeleton, which have changed.
    void weigh();
    void set_law(Law law) { options_.law = law; }
    /// Of every joint [Hz], 0.1 to 1000, and its damping (1: critical), 0.01 to 10.
    void set_gains(double frequency, double damping);
    /// Of the joint of one segment, until set_gains().
    void set_joint_gains(int segment, double frequency, double damping);
    /// The same under the law of the papers; each joint is held to what a step stands.
    void set_paper_gains(double frequency, double damping);

    /// What a joint exerted on its segment in the last step [N m, world].
    [[nodiscard]] Vector3 torque(int segment) const {
        return added_[segment] + body_.motor_torque(segment);
    }
    [[nodiscard]] const ControlOptions& options() const { return options_; }

  private:
    struct Gains {
        double kp, kd;
    };
    [[nodiscard]] Gains gains(int joint, double frequency) const;
    [[nodiscard]] double frequency(int joint, const Target& target) const;
    void add_torque(int joint, const Vector3& torque);
    void apply_implicit(int joint, const Target& target);
    void drive_motor(int joint, const Vector3& error, const Vector3& rate, const Gains& gains,
                     double most);
    void apply_paper(int joint, const Target& target);
    void feed_forward(const Target& target);

    OdeBody& body_;
    ControlOptions options_;
    double h_;
    std::vector<double> inertia_;       ///< of what hangs on a joint, its largest moment [kg m^2]
    std::vector<Vector3> own_inertia_;  ///< of the lighter side of a joint, by axis [kg m^2]
    std::vector<double> resistance_;
    /// Frequencies and damping of joints that have their own; 0: they have not.
    std::vector<double> own_frequency_, own_damping_;
    std::vector<Vector3> added_;     ///< torques of the last step that are not the motors'
    std::vector<int> hand_of_grip_;  ///< -1 for a joint that is no grip
    body::Acceleration acceleration_, forecast_;
    std::vector<Vector3> torques_;  ///< forecast, world frame of the target
};

}  // namespace percussionist::sim
