// A drummer at a kit over a whole piece: the posture of the body and the state of the kit at any
// time, from the strokes of its plan.
//
// Each limb has its key frames; trunk and legs sit; the head looks to where the hands play.
// Building takes a part of a second; at() is pure but for its arguments, and allocates nothing once
// these have their sizes.
#pragma once

#include <memory>
#include <vector>

#include "body/key_frames.hpp"
#include "body/kit_motion.hpp"

namespace percussionist::body {

class KitAnimation {
  public:
    /// The strokes are those of a plan for this kit, in order of time. Throws
    /// std::invalid_argument for strokes that no limb has a pose for.
    KitAnimation(const score::Kit& kit, std::span<const score::KitStroke> strokes);
    KitAnimation(const KitAnimation&) = delete;
    KitAnimation& operator=(const KitAnimation&) = delete;

    [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }
    [[nodiscard]] const KitPoses& poses() const { return poses_; }
    [[nodiscard]] const LimbMotion& motion(score::Limb limb) const { return limbs_[index(limb)]; }

    /// One pose is another. Throws std::invalid_argument for a joint the limb does not have.
    void edit(const score::PoseEdit& pose);
    /// Lays the key frames, by the scripts that the kit has now.
    void lay();

    /// At time t [s]; trunk and head alone, the limbs as they sit; all.
    void trunk_at(double t, Posture& posture) const;
    void at(double t, Posture& posture, Placement& placement) const;
    void kit_at(double t, const Placement& placement, std::vector<ObjectState>& states) const {
        kit_motion_.at(t, skeleton_, placement, states);
    }
    /// Where the limb meets what the event strikes, of the limb and of the thing, world [m].
    [[nodiscard]] Vector3 limb_point(const Placement& placement, score::Limb limb,
                                     std::size_t event) const;
    [[nodiscard]] Vector3 target(score::Limb limb, std::size_t event) const;

  private:
    struct Look {
        double time;
        double azimuth;  ///< to the left [rad]
    };
    void look_about();
    [[nodiscard]] double azimuth(double t) const;

    const score::Kit& kit_;
    std::vector<score::KitStroke> strokes_;
    Skeleton skeleton_;
    KitPoses poses_;
    std::vector<LimbMotion> limbs_;  ///< by Limb
    KitMotion kit_motion_;
    std::vector<Look> looks_;
    int head_;
};

}  // namespace percussionist::body
