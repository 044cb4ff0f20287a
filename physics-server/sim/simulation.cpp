#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace percussionist::sim {

using body::Hand;
using body::kHands;

namespace {

/// The hand is this much above the tip when the tip meets the head [m].
constexpr double kHandAboveTip = 0.035;
/// A raised tip comes back towards the player by this times its height squared [1/m].
constexpr double kArc = 0.5;
/// The grip is loose from this long before a contact to this long after [s].
constexpr double kLooseBefore = 0.004;
constexpr double kLooseAfter = 0.010;
/// Iterations with which inverse kinematics finds the first posture.
constexpr int kSettling = 60;
/// No joint is asked to turn faster by a clip, in each iteration [rad/s].
constexpr double kFastestTurn = 20.0;
/// Of inverse kinematics when it follows a clip, whose arms may be stretched [m].
constexpr double kClipDamping = 0.02;
/// And of its pull to rest: to a posture that goes with the tips.
constexpr double kClipPull = 0.05;
/// With the papers' law and tips: how fast an error that lasts is leaned against [1/s], how fast it
/// is forgotten [1/s], and how far a tip is leaned at most [m].
constexpr double kCartesianRate = 20.0;
constexpr double kForgetting = 0.5;
constexpr double kMostLean = 0.5;
/// In which time targets go over from one motion to another [s].
constexpr double kFade = 0.5;

/// Short steps need fewer iterations to follow.
body::InverseKinematicsOptions kinematics_options(double rate) {
    constexpr double kShortSteps = 2000.0;
    body::InverseKinematicsOptions o;
    if (rate >= kShortSteps) o.iterations = 1;
    return o;
}

double checked_rate(double rate) {
    if (!(rate >= 250.0 && rate <= 4000.0)) {
        throw std::invalid_argument("simulation: rate: expected 250 to 4000 Hz, got " +
                                    std::to_string(rate));
    }
    return rate;
}

}  // namespace

Simulation::Simulation(const SimulationOptions& options)
    : options_(options),
      h_(1.0 / checked_rate(options.rate)),
      skeleton_(body::make_skeleton(options.person)),
      kinematics_(skeleton_, kinematics_options(options.rate)),
      strength_(skeleton_, kinematics_.arms(), h_),
      tips_{StickTip(skeleton_, Hand::left), StickTip(skeleton_, Hand::right)},
      sticks_{skeleton_.stick_index(Hand::left), skeleton_.stick_index(Hand::right)},
      target_(skeleton_),
      solution_(skeleton_),
      solved_(skeleton_),
      actual_(skeleton_),
      wanted_(skeleton_),
      strokes_rest_(skeleton_),
      clip_rest_(skeleton_),
      faded_from_(skeleton_) {
    const double mass_factor = 1.0 + options.mass_error;
    body_ = std::make_unique<OdeBody>(skeleton_, world_, mass_factor);
    controller_ = std::make_unique<Controller>(*body_, options.control, h_);
    head_ = std::make_unique<Drumhead>(options.head, h_);

    strike_radius_ = {options.strike_radius, options.strike_radius};
    for (const Hand hand : kHands) offsets_[index(hand)] = MovingPlace(offset(hand));
    head_place_ = MovingPlace(head_goal());

    settle(0.0);
    target_.before = target_.now = target_.after = solution_;
    target_.placed_before = target_.placed_now = target_.placed_after = solved_;
    strength_.begin(solution_, solution_);
    body_->place(solved_);
    body_->read(actual_);

    forecast();
}

Vector3 Simulation::tip(Hand hand) const {
    const Vector3 ball = Vector3::UnitZ() * skeleton_.stick.tip_radius;
    return body_->tip_position(hand) - ball - strike_place(hand, time());
}

Vector3 Simulation::tip_target(Hand hand) const {
    const Vector3 ball = Vector3::UnitZ() * skeleton_.stick.tip_radius;
    return target_.placed_now.tip(skeleton_, hand) - ball - strike_place(hand, time());
}

bool Simulation::strike(Hand hand, double time, double speed, double height) {
    return aim(hand, {time, speed, height, forecast_->rebound(speed), {}});
}

bool Simulation::strike(Hand hand, double time, const body::StrokeShape& shape) {
    body::Aim aimed;
    aimed.time = time;
    aimed.rebound = forecast_->rebound(shape.impact);
    aimed.shape = shape;
    return aim(hand, aimed);
}

bool Simulation::aim(Hand hand, const body::Aim& aimed) {
    const double now = frontier();
    body::StrokePath bent = path(hand);
    if (!bent.aim(now, aimed)) return false;
    if (path(hand).aiming(now) && !bent.can_be_followed(now)) return false;
    own_path(hand) = bent;
    return true;
}

body::ArmTarget Simulation::arm_target(Hand hand, double t) const {
    const double height = path(hand).tip(t).position;
    const double raised = std::max(0.0, height);
    body::ArmTarget target;
    target.tip = strike_place(hand, t);
    const double head = target.tip.z();
    target.tip.x() -= kArc * raised * raised;
    target.tip.z() += skeleton_.stick.tip_radius + height;
    target.grip_height =
        head + skeleton_.stick.tip_radius + kHandAboveTip + path(hand).hand(t).position;
    return target;
}

body::ArmTargets Simulation::arm_targets(double t) {
    if (clip_) {
        const double there = clip_time_(t);
        const body::ArmTargets targets =
            played_ ? played_->targets(there, clip_rest_) : clip_->targets(there, clip_rest_);
        kinematics_.pull_to(clip_rest_);
        return targets;
    }
    return {arm_target(Hand::left, t), arm_target(Hand::right, t)};
}

void Simulation::settle(double t) {
    asked_ = asked_next_ = arm_targets(t);
    kinematics_.set_largest_turn(body::InverseKinematicsOptions().largest_turn);
    for (int i = 0; i < kSettling; ++i) kinematics_.solve(asked_, solution_, solved_);
    if (clip_) kinematics_.set_largest_turn(kFastestTurn * h_);
}

void Simulation::fill_target(double t) {
    asked_ = asked_next_;
    if (thumbs_up_.moves(t - h_)) turn_grip(t);
    // The papers' inverse kinematics knows no masses.
    const bool paper = controller_->options().law == Law::paper;
    kinematics_.set_arms(paper ? 1.0 : body::InverseKinematicsOptions().arms);
    if (clip_ && tracking_ == body::Tracking::joints) {
        clip_->posture(clip_time_(t), target_.after, target_.placed_after);
    } else {
        asked_next_ = arm_targets(t);
        kinematics_.solve(asked_next_, solution_, solved_);
        target_.after = solution_;
        target_.placed_after = solved_;
    }
    fade(t);
}

void Simulation::hold_to_strength() {
    if (clip_ && tracking_ == body::Tracking::joints) {
        strength_.begin(target_.now, target_.after);
    } else if (strength_.hold(target_.after)) {
        kinematics_.reach_by_hands(asked_next_, target_.after, target_.placed_after);
    }
}

void Simulation::begin_fade() {
    faded_from_ = target_.after;
    fade_start_ = time();
}

void Simulation::fade(double t) {
    const double s = (t - fade_start_) / kFade;
    if (s >= 1.0) return;
    const double share = body::minimum_jerk(s);
    for (std::size_t i = 0; i < target_.after.joints.size(); ++i) {
        target_.after.joints[i] = faded_from_.joints[i].slerp(share, target_.after.joints[i]);
    }
    body::forward_kinematics(skeleton_, target_.after, target_.placed_after);
}

void Simulation::follow(std::shared_ptr<const body::ClipFollower> clip,
                        std::function<double(double)> clock) {
    begin_fade();
    clip_ = std::move(clip);
    clip_time_ = std::move(clock);
    const body::Posture& mean = clip_->clip().mean();
    kinematics_.set_rest(mean);
    kinematics_.set_damping(kClipDamping);
    // Sticks alone have no posture that goes with them.
    kinematics_.set_rest_pull(
        clip_->clip().has_own_tips() ? body::InverseKinematicsOptions().rest_pull : kClipPull);
    solution_ = mean;
    settle(time());
}

void Simulation::play(std::shared_ptr<const body::PlayableClip> clip,
                      std::function<double(double)> clock) {
    played_ = std::move(clip);
    follow({played_, &played_->follower()}, std::move(clock));
    move_places();
}

void Simulation::begin_with(std::shared_ptr<const body::Clip> clip, double start) {
    const double now = time();
    played_.reset();
    follow(std::make_shared<body::ClipFollower>(std::move(clip), skeleton_),
           [begin = now - start](double t) { return t - begin; });
    fade_start_ = -1e9;
    for (const double t : {now - h_, now, now + h_}) {
        fill_target(t);
        if (t <= now) target_.advance();
    }
    strength_.begin(target_.before, target_.now);
    body_->place(target_.placed_now);
    body_->set_velocities(target_.placed_before, target_.placed_now, h_);
    asked_next_ = arm_targets(now);
    body_->read(actual_);
}

void Simulation::follow_strokes() {
    begin_fade();
    clip_.reset();
    played_.reset();
    move_places();
    kinematics_.set_rest(strokes_rest_);
    kinematics_.set_damping(body::InverseKinematicsOptions().damping);
    kinematics_.set_rest_pull(body::InverseKinematicsOptions().rest_pull);
    solution_ = strokes_rest_;
    settle(time());
}

void Simulation::set_tracking(body::Tracking tracking) {
    if (tracking == tracking_) return;
    tracking_ = tracking;
    if (!clip_) return;
    begin_fade();
    settle(time());
}

void Simulation::set_inverse(body::Inverse inverse) {
    if (clip_) begin_fade();  // the tips of strokes do as they are asked to
    kinematics_.set_inverse(inverse);
}

void Simulation::set_limits(int segment, const body::JointLimits& limits) {
    skeleton_.segments.at(segment).limits = limits;
}

void Simulation::correct_by_tips() {
    const body::InverseKinematics::Tasks error = kinematics_.errors(asked_, actual_);
    const auto limit = [](double length) {
        const double most = length;
        return [most](double v) { return std::clamp(v, -most, most); };
    };
    off_for_long_ += h_ * (error - kForgetting * off_for_long_);
    off_for_long_ = off_for_long_.unaryExpr(limit(kMostLean / kCartesianRate)).eval();
    const body::InverseKinematics::Tasks wish =
        (cartesian_gain_ * error + kCartesianRate * off_for_long_).unaryExpr(limit(kMostLean));
    wanted_ = target_.now;
    kinematics_.lean(wish, actual_, wanted_, target_.now);
}

/// Whether a tip is asked to be in the head.
bool Simulation::in_head(Hand hand, double t) const {
    if (!clip_) return path(hand).in_head(t);
    return played_ && played_->in_head(clip_time_(t), hand);
}

void Simulation::mark_contacts() {
    bool strikes = false;
    for (const Hand hand : kHands) {
        const auto in = [&](double offset) { return in_head(hand, time() + offset); };
        strikes = strikes || in(-h_) || in(0.0) || in(h_);
        target_.loose[sticks_[index(hand)]] =
            in(0.0) || in(kLooseBefore) || in(-kLooseAfter) || in(-0.5 * kLooseAfter);
    }
    std::fill(target_.strikes.begin(), target_.strikes.end(), strikes);
}

Face Simulation::face() const {
    Face face;
    face.middle = head_centre();
    face.velocity = (head_place_.at(time() + h_) - face.middle) / h_;
    return face;
}

void Simulation::step(std::vector<ContactEvent>& contacts) {
    fill_target(time() + h_);
    hold_to_strength();
    mark_contacts();
    const bool by_tips = tracking_ == body::Tracking::tips;
    if (controller_->options().law == Law::paper && by_tips) correct_by_tips();
    controller_->apply(target_);
    if (options_.head_there) strike_head(contacts);
    world_.step(h_);
    ++steps_;
    body_->read(actual_);
    target_.advance();
}

void Simulation::strike_head(std::vector<ContactEvent>& contacts) {
    const Face face = this->face();
    std::array<TouchingTip, 2> tips;
    for (const Hand hand : kHands) {
        StickTip& tip = tips_[index(hand)];
        tip.look(*body_);
        tips[index(hand)] = tip.against(face, *head_, actual_, controller_->resistance(), h_);
    }
    const std::array<double, 2> impulses = head_->step(time(), tips, contacts);
    for (const Hand hand : kHands) {
        const Vector3 impulse(0.0, 0.0, impulses[index(hand)]);
        tips_[index(hand)].struck(impulse);
        if (impulse.z() != 0.0) body_->add_tip_force(hand, impulse / h_);
    }
}

}  // namespace percussionist::sim
