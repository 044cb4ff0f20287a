// Poses: where a limb is when it strikes, and where before and after. Two of them for each limb and
// each event it plays, as in Kragtwijk, Nijholt and Zwiers, "An animated virtual drummer" (2001),
// 3.4: DOWN, the exact situation on contact, and UP, from where the loudest stroke falls.
//
// A hand's are found by inverse kinematics from the kit, the trunk standing still: DOWN has the
// middle of the stick's tip a tip's radius above its spot, the grip a little higher; UP is `rise`
// above that, the grip by 45 % of it. A foot's turn its pedal. Joints that the kit's `pose` lines
// name are as these say.
//
// The constructor takes a second's part and allocates; reading is pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "body/drummer.hpp"

namespace percussionist::body {

class InverseKinematics;

/// Rotations of a limb's joints, in the order of its parts.
using LimbPose = std::vector<Quaternion>;

struct StrikePoses {
    LimbPose down, up;
    double off = 0.0;  ///< how far DOWN is from the spot [m]
};

/// By index of a score::Limb.
template <class T>
using ByLimb = std::array<T, 4>;

class KitPoses {
  public:
    /// Farther off than this a limb does not play an event [m].
    static constexpr double kReaches = 0.002;

    /// Throws std::invalid_argument for a pose line of a joint the limb does not have.
    KitPoses(const Skeleton& skeleton, const score::Kit& kit);

    [[nodiscard]] const LimbParts& parts(score::Limb limb) const { return parts_[index(limb)]; }
    /// Empty if the event is none of the limb's.
    [[nodiscard]] const std::optional<StrikePoses>& of(score::Limb limb, std::size_t event) const {
        return strikes_[index(limb)][event];
    }
    /// Another pose in place of one. Throws std::invalid_argument for a joint the limb does not
    /// have.
    void edit(const score::PoseEdit& edit);
    /// Waiting.
    [[nodiscard]] const LimbPose& rest(score::Limb limb) const { return rest_[index(limb)]; }
    /// From where it sinks to that, and rises: a hand above all that is near.
    [[nodiscard]] const LimbPose& above_rest(score::Limb limb) const {
        return above_rest_[index(limb)];
    }
    /// Where the middle of the stick's tip is when a hand has this pose, world [m].
    [[nodiscard]] Vector3 tip(score::Limb hand, const LimbPose& pose) const;
    /// Trunk, head and all: the others' joints are those of the poses.
    [[nodiscard]] const Posture& seat() const { return seat_; }

  private:
    void add_hand(InverseKinematics& kinematics, score::Limb hand);
    void add_foot(score::Limb foot);
    [[nodiscard]] double off_spot(score::Limb hand, std::size_t event) const;
    [[nodiscard]] LimbPose taken(score::Limb limb, const Posture& posture) const;

    const Skeleton& skeleton_;
    const score::Kit& kit_;
    Posture seat_;
    ByLimb<LimbParts> parts_;
    ByLimb<LimbPose> rest_, above_rest_;
    ByLimb<std::vector<std::optional<StrikePoses>>> strikes_;
};

/// Sets which hands reach which events of the kit. Throws std::invalid_argument naming an event
/// that no limb of his reaches, and by how much.
void note_reach(const KitPoses& poses, score::Kit& kit);

/// All poses as lines of a kit file say them, to be edited.
std::vector<score::PoseEdit> all_poses(const Skeleton& skeleton, const KitPoses& poses,
                                       const score::Kit& kit);

}  // namespace percussionist::body
