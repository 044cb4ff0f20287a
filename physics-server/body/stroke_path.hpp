// The path of one stick's tip and of the hand that holds it, from stroke to stroke.
//
// Heights are above the head; the path is made of quintic pieces (position, velocity and
// acceleration continuous: Flash and Hogan 1985 for the smoothness of such hand paths) between
//     where the tip is - rebound - waiting height - raised - impact - the dip into the head -
// where the dip is not a wish but a forecast: the head throws the stick back, and a target that
// knows how far, how long and how fast leaves the controller nothing to fight. aim() may be called
// at any time, also while a stroke is under way: the path goes on from where it is, so that a
// change of tempo bends it without a jump. The hand makes a share of every rise of the tip, so that
// the stick never points straight up.
//
// No allocation after construction; deterministic; one thread.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "body/gesture.hpp"

namespace percussionist::body {

/// The hand goes with this share of what its tip rises.
constexpr double kHandShare = 0.45;

/// From 0 at s = 0 to 1 at s = 1, at rest at both ends.
constexpr double minimum_jerk(double s) {
    return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

struct PathState {
    double position = 0.0;      ///< [m]
    double velocity = 0.0;      ///< [m/s]
    double acceleration = 0.0;  ///< [m/s^2]
};

/// A polynomial of degree five that joins two states.
class Quintic {
  public:
    Quintic() = default;
    /// From `a` at time t0 to `b` at t1 > t0 [s].
    Quintic(double t0, const PathState& a, double t1, const PathState& b);
    [[nodiscard]] PathState at(double t) const;
    [[nodiscard]] double end() const { return end_; }
    /// The time at which it stops rising and begins to fall, if it does so once inside; else end().
    [[nodiscard]] double top() const;

  private:
    double start_ = 0.0, end_ = 0.0;
    std::array<double, 6> c_{};
};

/// What the head is expected to do with a stick that meets it (see sim/impact_forecast.hpp).
struct Rebound {
    double speed = 0.0;     ///< upwards, when the stick leaves the head [m/s]
    double duration = 0.0;  ///< of the contact [s]
};

struct Aim {
    double time = 0.0;    ///< of the impact [s]
    double speed = 0.0;   ///< of the tip, downwards, at the impact [m/s]
    double height = 0.0;  ///< to raise the tip to, if there is time [m]
    Rebound rebound;
    /// Of a gesture: its raise, speeds and rebound; speed and height above are then not used. With
    /// little time it is raised less. Its rebound stays its own if another stroke follows, where
    /// there is time for both: the end of one stroke prepares the next.
    std::optional<StrokeShape> shape = std::nullopt;
};

class StrokePath {
  public:
    static constexpr double kWaitingHeight = 0.10;  ///< of the tip between strokes far apart [m]
    /// The shortest time in which the path can be brought to a stroke from anywhere [s].
    static constexpr double kShortestAim = 0.06;

    /// The tip waits from `now` on.
    explicit StrokePath(double now = 0.0);

    /// From `now` on, strike so; what was aimed at before and not yet struck is forgotten. While
    /// the tip is in the head the new path begins where it leaves it. False, and nothing changes,
    /// if the time left is shorter than kShortestAim.
    bool aim(double now, const Aim& aim);
    /// Whether what lies between `now` and the impact stays above the head, below 0.75 m, and
    /// slower to turn than 300 m/s^2: a stroke that is moved too late or too far does not.
    [[nodiscard]] bool can_be_followed(double now) const;
    /// From `now` on, no further stroke: rebound or sink to the waiting height and stay there.
    void rest(double now);

    [[nodiscard]] PathState tip(double t) const;
    /// Height of the hand against its height when the tip touches the head.
    [[nodiscard]] PathState hand(double t) const;
    /// Whether at t the tip is forecast to be in the head.
    [[nodiscard]] bool in_head(double t) const { return next_.holds(t) || last_.holds(t); }
    /// Whether an impact aimed at still lies ahead of `now`.
    [[nodiscard]] bool aiming(double now) const { return now < next_.impact; }
    /// The time of the impact last aimed at [s]; -infinity before the first.
    [[nodiscard]] double impact() const { return next_.impact; }

  private:
    /// Few pieces lie between two strokes; a fixed list holds them.
    class Track {
      public:
        void restart() { count_ = 0; }
        void add(double t0, const PathState& a, double t1, const PathState& b);
        [[nodiscard]] PathState at(double t) const;

      private:
        std::array<Quintic, 16> pieces_;
        int count_ = 0;
    };
    /// Where both tracks have been drawn to.
    struct Pen {
        double time;
        PathState tip, hand;
    };
    /// Puts the pen down now, or where a dip under way ends.
    Pen cut(double now);
    [[nodiscard]] double free_from(double now) const;
    void draw(Pen& pen, double t, const PathState& tip, const PathState& hand);
    void draw_rest(Pen& pen, double t, double height);
    /// When [s] and at which height [m] a rebound comes to rest.
    struct Turn {
        double time = -std::numeric_limits<double>::infinity();
        double height = 0.0;
    };
    static Turn turn(const Pen& leaving, const std::optional<StrokeShape>& struck);
    void draw_turn(Pen& pen, const Turn& turn);
    void wait(Pen& pen, const Turn& turn);
    /// How high the stick is raised [m], how long it then comes down and went up before [s], and
    /// from which height if there is time to wait [m].
    struct Raise {
        double height, down, time, from;
    };
    static Raise raise_for(const Aim& aim, const Pen& pen);
    void raise(Pen& pen, const Aim& aim);
    void strike(Pen& pen, const Aim& aim);

    Track tip_, hand_;
    /// The stay in the head after an impact.
    struct Dip {
        double impact = -std::numeric_limits<double>::infinity();
        double leaves = impact;
        [[nodiscard]] bool holds(double t) const { return t >= impact && t < leaves; }
    };
    Dip next_, last_;                   ///< of the stroke aimed at, and of the one before it
    std::optional<StrokeShape> aimed_;  ///< gesture of the stroke aimed at, if it has one
    Turn turn_;                         ///< of the stroke before it
};

}  // namespace percussionist::body
