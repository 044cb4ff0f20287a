// Key frames: what a limb does over a piece, as poses at times and scripts between them.
//
// A stroke is three key frames, after Kragtwijk, Nijholt and Zwiers, "An animated virtual drummer"
// (2001), 3.4, with diff = UP - DOWN:
//     before  = DOWN + velocity diff                 `fall` before the contact
//     contact = DOWN                                 at the note's time, and held for 5 ms
//     after   = DOWN + velocity elasticity diff      `rise` after that
// The softest notes are raised as those of velocity 0.06, with a foot 0.25: less could not be seen.
// Where two strokes on one object overlap, or leave no time to turn, after and before become one:
// where the straight lines of both cross, half of the way between both poses. From object to object
// both stay, lower and sooner the less time there is, and at the height of the higher of the two: a
// stick leaves the one upwards and comes to the other from above. Before and after long pauses the
// limb waits.
//
// Between key frames each joint follows its script (Script of core/score/kit.hpp): the share of
// the way, through whose points runs a cubic; without one it starts slowly before a contact, ends
// slowly after it, both between.
//
// The constructors allocate; at() does not once `pose` has its size. Any thread.
#pragma once

#include <span>
#include <vector>

#include "body/kit_poses.hpp"
#include "core/score/kit_plan.hpp"

namespace percussionist::body {

enum class KeyKind { rest, before, contact, release, after, merged };
inline constexpr std::array<std::string_view, 6> kKeyKindNames{"rest",    "before", "contact",
                                                               "release", "after",  "merged"};

struct KeyFrame {
    double time = 0.0;  ///< [s]
    KeyKind kind = KeyKind::rest;
    LimbPose pose;
};

/// How long the ways of a stroke take [s].
struct StrokeTimes {
    double fall = 0.11;
    double rise = 0.14;
    double held = 0.005;
};
StrokeTimes times_of(score::Limb limb);

/// The key frames of one limb's strokes, which are in order of time.
std::vector<KeyFrame> key_frames(const KitPoses& poses, const score::Kit& kit, score::Limb limb,
                                 std::span<const score::KitStroke> strokes);

/// Of the foot on the hi-hat's pedal: besides its own strokes it lets go before hands play the
/// hi-hat open, and presses before they play it closed. `strokes` are those of all limbs.
std::vector<KeyFrame> hat_key_frames(const KitPoses& poses, const score::Kit& kit, score::Limb foot,
                                     std::span<const score::KitStroke> strokes);

/// a (share 0) to b (share 1), joint by joint.
LimbPose blend(const LimbPose& a, const LimbPose& b, double share);

/// What a limb does between its key frames.
class LimbMotion {
  public:
    LimbMotion(const Skeleton& skeleton, const score::Kit& kit, const LimbParts& parts,
               std::vector<KeyFrame> keys);

    [[nodiscard]] const std::vector<KeyFrame>& keys() const { return keys_; }
    /// At time t [s], into the posture's joints.
    void at(double t, Posture& posture) const;

  private:
    LimbParts parts_;
    std::vector<KeyFrame> keys_;
    /// By phase and joint; empty: the usual way.
    std::array<std::vector<std::vector<double>>, 3> scripts_;
};

/// The share of the way that a script has gone at part u, 0 to 1, of the time.
double along(std::span<const double> curve, double u);

}  // namespace percussionist::body
