// Lets through what a tracker measured anew, and holds back what no hand can do.
//
// A pose exactly like the one before is the device repeating itself. A pose that is further off
// than a hand or stick moves in the time is a jump: it waits for the next one, and if that is near
// it, it was real and a new beginning is made; else it never was. Pure; real-time safe; one thread.
#pragma once

#include <optional>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

struct TimedPose {
    double time = 0.0;  ///< [s]
    linear::Pose pose;
};

struct PoseGateSettings {
    double top_speed = 15.0;   ///< of the receiver [m/s]
    double slack = 0.02;       ///< that a tracker may be off besides [m]
    double longest_gap = 0.5;  ///< after which anything is possible [s]
};

class PoseGate {
  public:
    explicit PoseGate(const PoseGateSettings& settings = {}) : settings_(settings) {}

    enum class Verdict { kGood, kFresh, kRepeat, kJump };
    /// kFresh: good, but what came before is of another path. Times that do not rise are repeats.
    Verdict judge(const TimedPose& pose) noexcept;

    std::size_t repeats() const { return repeats_; }
    std::size_t jumps() const { return jumps_; }

  private:
    bool near(const TimedPose& a, const TimedPose& b) const noexcept;
    PoseGateSettings settings_;
    std::optional<TimedPose> last_, suspect_;
    std::size_t repeats_ = 0, jumps_ = 0;
};

}  // namespace percussionist::motion
