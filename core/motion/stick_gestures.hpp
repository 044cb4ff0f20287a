// From the poses of a tracker's receivers to strokes, gestures and a damping hand: what a drum that
// is not there has to know.
//
// One receiver is on the stick, one may be on the player or the frame (then all is seen from there,
// and leaning changes nothing), one on the other hand, which damps where it presses into the head
// from behind. Each end of the stick is a sphere. Until there is a plane, strikes are told from the
// movement alone; taps on a real surface, three and more, make a plane. See plane_strike.hpp,
// free_strike.hpp, gesture_fit.hpp, moving_frame.hpp, drum_plane.hpp. Pure; add() is real-time
// safe.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/motion/drum_plane.hpp"
#include "core/motion/free_strike.hpp"
#include "core/motion/gesture_fit.hpp"
#include "core/motion/moving_frame.hpp"
#include "core/motion/plane_strike.hpp"

namespace percussionist::motion {

enum class Detection { kNone, kPlane, kFree };

struct StickGesturesSettings {
    int stick = 1, frame = 0, hand = 0;  ///< stations; 0: none
    Detection detection = Detection::kFree;
    std::array<std::optional<Vector3>, 2> tips{Vector3::Zero()};  ///< in the stick's frame [m]
    PlaneStrikeSettings plane;
    FreeStrikeSettings free;
    GestureFitSettings fit;
    double touch = 0.03;       ///< from the hand's receiver to the head when it touches [m]
    double full_press = 0.01;  ///< from there into the head, for a pressure of 1 [m]
};

/// The damping hand on the head.
struct Press {
    Place place;
    double pressure = 0.0;  ///< 0 to 1
};

struct StickEvents {
    std::array<std::optional<PlaneStrike>, 2> plane;  ///< by the end of the stick
    std::array<std::optional<FreeStrike>, 2> free;
    std::optional<Gesture> gesture;  ///< of the first tip
    std::optional<Press> press;
};

class StickGestures {
  public:
    explicit StickGestures(const StickGesturesSettings& settings = {});

    StickEvents add(int station, const TimedPose& world_from_receiver) noexcept;

    void set(const StickGesturesSettings& settings);
    const StickGesturesSettings& settings() const { return settings_; }

    /// In the frame of reference.
    void set_drum(const Pose& frame_from_drum);
    const std::optional<Pose>& drum() const { return frame_from_drum_; }

    /// Keeps where the first tip is now, or a place in the frame of reference; answers how many are
    /// kept. At most 64.
    std::size_t tap();
    std::size_t tap(const Vector3& place);
    void clear_taps() { taps_.clear(); }
    /// Throws as fit_plane(). The taps are cleared.
    FittedPlane fit_drum();

    std::size_t repeats() const;
    std::size_t jumps() const;

  private:
    std::optional<Pose> frame_from(const TimedPose& world_from_receiver) const noexcept;
    StickEvents add_stick(const TimedPose& pose) noexcept;
    StickEvents add_hand(const TimedPose& pose) const noexcept;
    void reset_stick() noexcept;

    StickGesturesSettings settings_;
    std::array<PoseGate, 4> gates_;
    MovingFrame frame_;
    std::array<PlaneStrikeDetector, 2> on_plane_;
    std::array<FreeStrikeDetector, 2> in_air_;
    GestureFit fit_;
    std::optional<Pose> frame_from_drum_;
    std::optional<Vector3> last_tip_;
    Vector3 above_ = Vector3::Zero();  // where the tip is held, on the whole
    std::vector<Vector3> taps_;
};

}  // namespace percussionist::motion
