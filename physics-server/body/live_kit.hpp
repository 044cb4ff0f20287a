// A drummer at a kit while the music plays: from step to step of time, where a song is, notes that
// nobody knew of before; out come a posture, what the kit does, and contacts.
//
// What moves the body stands behind this: key frames (LiveDrummer), or physics led by them
// (sim::SimulatedDrummer).
// One thread; time [s] is an argument and grows.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "body/kit_motion.hpp"
#include "body/touch.hpp"
#include "core/score/kit_plan.hpp"
#include "core/score/song_clock.hpp"

namespace percussionist::body {

struct KitContact {
    double time = 0.0;  ///< [s]
    score::Limb limb = score::Limb::right_hand;
    std::size_t event = 0;
    double velocity = 0.0;  ///< of the note, 0..1
    int stroke = -1;        ///< of the plan; -1: of a live note
    bool sounded = false;   ///< a live note that somebody has let sound already
    /// Where a body made it; else event and velocity say all. `time` is then when it was asked for.
    std::optional<Touch> touch{};
};

/// What became of a live note.
struct LiveStroke {
    std::optional<score::Limb> limb;  ///< none: no limb was free in time
    double time = 0.0;                ///< of the contact to come [s]
};

class LiveKit {
  public:
    virtual ~LiveKit() = default;
    LiveKit() = default;
    LiveKit(const LiveKit&) = delete;
    LiveKit& operator=(const LiveKit&) = delete;

    /// The strokes of a plan for the kit, in order of time; those before are forgotten. Throws
    /// std::invalid_argument for a stroke that its limb does not play.
    virtual void load(std::vector<score::KitStroke> strokes) = 0;
    /// To the time `now`, in which the song went a step.
    virtual void step(double now, const score::SongStep& song) = 0;
    /// A note that came between two steps: struck as soon as a limb can be there.
    virtual LiveStroke strike(std::size_t event, double velocity, bool sounded) = 0;

    [[nodiscard]] virtual const Skeleton& skeleton() const = 0;
    [[nodiscard]] virtual const Placement& placement() const = 0;
    [[nodiscard]] virtual const std::vector<ObjectState>& objects() const = 0;
    /// Those of the last step, in order of time.
    [[nodiscard]] virtual const std::vector<KitContact>& contacts() const = 0;
    /// Strokes of the song that were not struck: after a jump, or for a live note.
    [[nodiscard]] virtual int passed_over() const = 0;
};

}  // namespace percussionist::body
