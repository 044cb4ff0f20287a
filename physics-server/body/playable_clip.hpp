// A clip as something to play on one drum: the strokes that are in it, and how its tips are bent so
// that each of them meets the head.
//
// Captured strokes end at heights of their own: on a real drum by millimetres, in the air by
// centimetres. The head is put at their median height, and the path of each tip is lifted or
// lowered to meet it: by what each stroke lacks at its low point, smoothly from one to the next.
// Before its beginning and after its end the sticks wait above the head. Joints that are followed
// as they were captured are not bent.
//
// Building allocates and takes its time (a body is looked at 500 times a second); reading allocates
// nothing. One thread at a time.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "body/clip_follower.hpp"
#include "body/gesture.hpp"
#include "body/stroke_measure.hpp"

namespace percussionist::body {

struct CapturedStroke {
    Hand hand = Hand::right;
    double touch = 0.0;  ///< when the bent path comes down to the head, from the beginning [s]
    double leave = 0.0;  ///< when it is out of it again [s]
    StrokeShape shape;   ///< as captured
};

/// A height that goes smoothly (up to acceleration) from each of some points in time to the next,
/// and stays before the first and after the last.
class Lift {
  public:
    void add(double time, double height);  ///< times ascend
    [[nodiscard]] double at(double t) const;

  private:
    struct Point {
        double time, height;
    };
    std::vector<Point> points_;
};

class PlayableClip {
  public:
    /// The clip as a body of this skeleton plays it.
    PlayableClip(std::shared_ptr<const Clip> clip, const Skeleton& skeleton);
    PlayableClip(const PlayableClip&) = delete;
    PlayableClip& operator=(const PlayableClip&) = delete;

    [[nodiscard]] const ClipFollower& follower() const { return follower_; }
    /// In order of time; none if nothing in it looks like one.
    [[nodiscard]] const std::vector<CapturedStroke>& strokes() const { return strokes_; }
    /// Where the middle of a tip touches the head, amid both hands, world [m]; if it has strokes.
    [[nodiscard]] const Vector3& place() const { return place_; }
    /// How far a stroke is bent at most [m].
    [[nodiscard]] double worst_lift() const { return worst_lift_; }

    /// See ClipFollower; the tips are bent.
    [[nodiscard]] ArmTargets targets(double t, Posture& rest) const;
    /// Whether a tip is in the head at t [s].
    [[nodiscard]] bool in_head(double t, Hand hand) const;

  private:
    struct Path {
        HeightSeries heights;
        std::vector<std::size_t> lows;
    };
    [[nodiscard]] Path path_of(Hand hand) const;
    [[nodiscard]] Vector3 tip(double t, Hand hand) const;
    void find_place(const std::array<Path, 2>& paths);
    void bend(Hand hand, const Path& path);

    Skeleton skeleton_;
    ClipFollower follower_;
    std::vector<CapturedStroke> strokes_;
    std::array<std::vector<std::array<double, 2>>, 2> in_head_;  ///< touch and leave, by Hand
    std::array<Lift, 2> lifts_;
    Vector3 place_ = Vector3::Zero();
    double worst_lift_ = 0.0;
    mutable Posture posture_;  ///< memory for tip()
    mutable Placement placement_;
};

}  // namespace percussionist::body
