// How well a key-framed animation does what its strokes ask for: measured on the animation itself.
//
// Of each stroke: how far the limb's point is from its spot at the note's time, and how much
// earlier it came there (to within a tenth of a millimetre). Of the whole: the tips' top speed, and
// how often they go through a face.
#pragma once

#include <vector>

#include "body/kit_animation.hpp"

namespace percussionist::body {

struct StrokeCheck {
    double off = 0.0;    ///< from the spot at the note's time [m]
    double early = 0.0;  ///< [s]
};

/// Of one stroke, which the animation plays.
StrokeCheck check_stroke(const KitAnimation& animation, const score::KitStroke& stroke);

/// A tip came 5 mm below a face from above it.
struct Through {
    double time = 0.0;  ///< [s]
    Hand hand = Hand::left;
    std::size_t object = 0;
};

/// Watches the sticks from frame to frame.
class StickWatch {
  public:
    explicit StickWatch(const KitAnimation& animation, const score::Kit& kit);

    /// Frames in order of time [s].
    void see(double time, const Placement& placement);
    [[nodiscard]] double top_speed() const { return top_speed_; }   ///< of a tip [m/s]
    [[nodiscard]] double top_speed_at() const { return fast_at_; }  ///< [s]
    [[nodiscard]] const std::vector<Through>& through() const { return through_; }

  private:
    void look_below(double time, Hand hand, const Vector3& before, const Vector3& now);

    const KitAnimation& animation_;
    const score::Kit& kit_;
    double last_time_ = 0.0;
    bool first_ = true;
    std::array<Vector3, 2> last_{Vector3::Zero(), Vector3::Zero()};
    double top_speed_ = 0.0, fast_at_ = 0.0;
    std::vector<Through> through_;
};

}  // namespace percussionist::body
