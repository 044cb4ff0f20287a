// The percussionist at the drum: what is asked for (strokes, a clip), what is simulated (body,
// sticks, head), what comes out (contacts, poses).
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
#include <functional>
#include <memory>
#include <vector>

#include "body/clip_follower.hpp"
#include "body/inverse_dynamics.hpp"
#include "body/inverse_kinematics.hpp"
#include "body/joint_strength.hpp"
#include "body/playable_clip.hpp"
#include "body/posture.hpp"
#include "body/stroke_path.hpp"
#include "sim/contact_event.hpp"
#include "sim/controller.hpp"
#include "sim/drumhead.hpp"
#include "sim/impact_forecast.hpp"
#include "sim/moving_place.hpp"
#include "sim/ode_body.hpp"
#include "sim/stick_tip.hpp"

namespace percussionist::sim {

struct SimulationOptions {
    double rate = 1000.0;  ///< steps a second of simulated time, 250 to 4000 [Hz]
    body::Anthropometry person;
    ControlOptions control;
    DrumheadOptions head;
    double head_height = 0.92;    ///< of the head above the floor [m]
    double strike_radius = 0.75;  ///< where the sticks meet the head, share of its radius
    double strikes_apart = 0.16;  ///< distance between the places of both sticks [m]
    bool head_there = true;       ///< false: the sticks move in free air
    /// The simulated body weighs this much more than the one that control reckons with, a share.
    double mass_error = 0.0;
};

class Simulation {
  public:
    /// Throws std::invalid_argument naming the option that is out of range.
    explicit Simulation(const SimulationOptions& options);

    /// A step of h; contacts that ended in it are appended to `contacts`.
    void step(std::vector<ContactEvent>& contacts);

    [[nodiscard]] double time() const { return static_cast<double>(steps_) * h_; }
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    [[nodiscard]] double step_length() const { return h_; }
    /// The earliest time for which something can still be asked: targets up to now are made.
    [[nodiscard]] double frontier() const { return time() + h_; }

    /// Asks for a stroke; see body::StrokePath::aim. The rebound is forecast here. False, and the
    /// stroke under way stays as it is, if it cannot be bent so.
    bool strike(body::Hand hand, double time, double speed, double height);
    /// The same, in the shape of a gesture.
    bool strike(body::Hand hand, double time, const body::StrokeShape& shape);
    void rest(body::Hand hand) { own_path(hand).rest(frontier()); }
    [[nodiscard]] const body::StrokePath& path(body::Hand hand) const {
        return paths_[static_cast<int>(hand)];
    }

    // How the body is moved. All may be called between any two steps; targets go over from one to
    // the other smoothly. Setting the learnt inverse takes some 50 ms, and so does begin_with().

    /// Plays a clip (of this body's skeleton), the head where the clip strikes. `clock` says where
    /// in the clip [s] it is at a simulated time; before its beginning it waits there.
    void play(std::shared_ptr<const body::PlayableClip> clip, std::function<double(double)> clock);
    /// Follows a clip as it is, with the body put where the clip is at `start` [s], moving as it
    /// does; the head stays.
    void begin_with(std::shared_ptr<const body::Clip> clip, double start = 0.0);
    /// Follows the strokes asked for again.
    void follow_strokes();
    /// Null while it follows strokes.
    [[nodiscard]] const body::ClipFollower* following() const { return clip_.get(); }
    /// Of a clip: joints or tips. Strokes are paths of the tips: by joints, inverse kinematics
    /// alone leads them; by tips, errors of the simulated tips are leaned against too, where the
    /// law leaves any (the papers').
    void set_tracking(body::Tracking tracking);
    void set_inverse(body::Inverse inverse);
    /// How the sticks are held: palms down (german) or thumbs up (french). Strokes alone.
    void set_grip(body::Grip grip);
    /// Gains, and the law: see Controller.
    Controller& controller() { return *controller_; }
    [[nodiscard]] const Controller& controller() const { return *controller_; }
    /// The papers' law follows tips by leaning against the errors of the simulated ones, equation 1
    /// closed over the body: this much for an error as it comes (and more for one that lasts).
    void set_cartesian_gain(double gain) { cartesian_gain_ = gain; }
    // What it plays with and where. All between any two steps; places go over smoothly, strokes
    // under way go on. All throw std::invalid_argument and then change nothing.

    /// Where a stick is to meet the head: 0.05 to 0.95 of its radius, towards the player. The head
    /// moves to where the arms reach that with ease, as a player would step nearer.
    void set_strike_radius(body::Hand hand, double share);
    [[nodiscard]] double strike_radius(body::Hand hand) const {
        return strike_radius_[static_cast<int>(hand)];
    }
    /// Of the head above the floor, 0.6 to 1.2 m.
    void set_head_height(double height);
    /// Another skin, of a radius from 0.1 to 0.6 m; takes some milliseconds.
    void set_membrane(const modal::Membrane& membrane);
    /// Of both sticks, 0.01 to 0.3 kg, and of their felt or wood (modal::Mallet::stiffness), 1e5 to
    /// 1e11; takes some milliseconds.
    void set_mallet(double mass, double stiffness);
    [[nodiscard]] const SimulationOptions& options() const { return options_; }

    /// Of the joint of one segment.
    void set_limits(int segment, const body::JointLimits& limits);

    [[nodiscard]] const body::Skeleton& skeleton() const { return skeleton_; }
    /// What the controller was asked for in the last step, at time().
    [[nodiscard]] const body::Posture& posture_asked() const { return target_.now; }
    /// The middle of a tip in it, world [m].
    [[nodiscard]] Vector3 tip_asked(body::Hand hand) const {
        return target_.placed_now.tip(skeleton_, hand);
    }
    /// Where the segments are; true to the last step.
    [[nodiscard]] const body::Placement& placement() const { return actual_; }
    /// The middle of a tip against the point of the head it strikes, world axes: z 0 at the touch.
    [[nodiscard]] Vector3 tip(body::Hand hand) const;
    /// Where the target has it.
    [[nodiscard]] Vector3 tip_target(body::Hand hand) const;
    /// The head's middle, world [m].
    [[nodiscard]] Vector3 head_centre() const { return head_place_.at(time()); }
    /// A tip, where it strikes, world [m].
    [[nodiscard]] Vector3 strike_place(body::Hand hand, double t) const {
        return head_place_.at(t) + offsets_[static_cast<int>(hand)].at(t);
    }
    /// False once the simulation has gone astray (it never should).
    [[nodiscard]] bool sane() const { return body_->sane(); }

  private:
    body::StrokePath& own_path(body::Hand hand) { return paths_[static_cast<int>(hand)]; }
    bool aim(body::Hand hand, const body::Aim& aimed);
    [[nodiscard]] body::ArmTarget arm_target(body::Hand hand, double t) const;
    [[nodiscard]] body::ArmTargets arm_targets(double t);
    void follow(std::shared_ptr<const body::ClipFollower> clip,
                std::function<double(double)> clock);
    [[nodiscard]] bool in_head(body::Hand hand, double t) const;
    void fill_target(double t);
    void hold_to_strength();
    void fade(double t);
    void begin_fade();
    void settle(double t);
    [[nodiscard]] Vector3 offset(body::Hand hand) const;
    [[nodiscard]] Vector3 head_goal() const;
    void move_places();
    void forecast();
    [[nodiscard]] body::Posture grip_rest(double thumbs_up) const;
    void turn_grip(double t);
    void correct_by_tips();
    void mark_contacts();
    void strike_head(std::vector<ContactEvent>& contacts);
    [[nodiscard]] Face face() const;

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
    body::JointStrength strength_;  ///< of the joints of arms and trunk
    std::array<StickTip, 2> tips_;
    std::array<int, 2> sticks_;  ///< segments, by Hand
    std::array<body::StrokePath, 2> paths_;
    MovingPlace head_place_;              ///< of its middle, world [m]
    std::array<MovingPlace, 2> offsets_;  ///< from there to where each stick meets it [m]
    std::array<double, 2> strike_radius_;
    MovingNumber thumbs_up_;  ///< the grip: 0 german, 1 french
    Target target_;
    body::Posture solution_;  ///< of inverse kinematics
    body::Placement solved_, actual_;
    std::shared_ptr<const body::ClipFollower> clip_;
    std::shared_ptr<const body::PlayableClip> played_;  ///< that it is of, if it is played
    std::function<double(double)> clip_time_;           ///< where in it [s]
    body::Tracking tracking_ = body::Tracking::tips;
    double cartesian_gain_ = 3.0;
    body::ArmTargets asked_, asked_next_;  ///< of the tips at time() and a step later
    body::InverseKinematics::Tasks off_for_long_ =
        body::InverseKinematics::Tasks::Zero();  ///< integral of the tips' errors [m s]
    body::Posture wanted_;                       ///< by inverse kinematics, before it is corrected
    body::Posture strokes_rest_;                 ///< to which strokes are pulled: the grip
    body::Posture clip_rest_;                    ///< to which a clip's tips are pulled now
    body::Posture faded_from_;  ///< what was asked for when something else began to be
    double fade_start_ = -1e9;  ///< when that was [s]
};

}  // namespace percussionist::sim
