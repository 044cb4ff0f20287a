// A frame of reference that moves: the player's chest, or the drum's rim, as a tracker sees it.
//
// Receivers are measured one after the other; to see one from another, both are brought to the same
// instant. Between two poses of the frame that is exact but for its jerks; after the last one the
// frame is taken to go on as it went, for 50 ms at most (one that leans and turns is then wrong by
// a tenth of a millimetre or so; waiting for its next pose would cost up to 33 ms). Pure; real-time
// safe.
#pragma once

#include <algorithm>
#include <optional>

#include "core/motion/pose_gate.hpp"
#include "core/motion/recent.hpp"

namespace percussionist::motion {

class MovingFrame {
  public:
    /// In order of time.
    void add(const TimedPose& world_from_frame) noexcept { poses_.add(world_from_frame); }
    void reset() noexcept { poses_.clear(); }

    /// Where it is then; nothing while it is not known.
    std::optional<linear::Pose> at(double time) const noexcept {
        if (poses_.size() == 0) {
            return std::nullopt;
        }
        if (poses_.size() == 1) {
            return poses_[0].pose;
        }
        std::size_t later = 0;  // the later one of the two poses around
        while (later + 2 < poses_.size() && poses_[later + 1].time > time) {
            ++later;
        }
        const TimedPose &a = poses_[later + 1], &b = poses_[later];
        const double until = std::min(time, b.time + kLongestGuess);
        return interpolate(a.pose, b.pose, (until - a.time) / (b.time - a.time));
    }

  private:
    static constexpr double kLongestGuess = 0.05;  // [s]
    Recent<TimedPose, 8> poses_;
};

}  // namespace percussionist::motion
