// One limb of a drummer while the music plays: it follows the song's key frames, or, for a while,
// key frames of its own; where it has to leave one for the other it bends from where it is.
//
// With B the song's pose and P the one it comes from, B(t) exp(w(t) log(B0^-1 P)), w falling from 1
// to 0 within the time it is given: from then on it is the song's, exactly.
//
// One thread; perform() allocates, at() does not once the limb has moved.
#pragma once

#include <optional>

#include "body/key_frames.hpp"

namespace percussionist::body {

class LiveLimb {
  public:
    LiveLimb(const Skeleton& skeleton, const score::Kit& kit, const LimbParts& parts);

    /// Key frames of its own, in time of the world; the first is where it is.
    void perform(std::vector<KeyFrame> keys);
    /// Those it performs; none: it follows the song.
    [[nodiscard]] const std::vector<KeyFrame>* performed() const {
        return own_ ? &own_->keys() : nullptr;
    }
    [[nodiscard]] bool over(double now) const { return own_ && now >= own_->keys().back().time; }
    /// To the song's motion, from where it is, within some time [s].
    void bend(double within);

    /// At time `now` of the world and `position` of the song, into the posture's joints.
    void at(double now, const LimbMotion& song, double position, Posture& posture);
    [[nodiscard]] const LimbPose& pose() const { return pose_; }

  private:
    const Skeleton& skeleton_;
    const score::Kit& kit_;
    LimbParts parts_;
    std::optional<LimbMotion> own_;
    LimbPose pose_;                 ///< the last
    double now_ = 0.0;              ///< of it
    std::vector<Vector3> residue_;  ///< against the song's, at the bend's beginning [rad]
    double bend_from_ = 0.0, bend_time_ = 0.0;
    bool bends_ = false;  ///< from the next at() on
};

}  // namespace percussionist::body
