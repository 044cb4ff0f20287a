// A number, and a place, that move to where they are sent, smoothly: value, velocity and
// acceleration never jump, also when they are sent elsewhere on their way.
//
// No allocation; deterministic; one thread.
#pragma once

#include <array>

#include "body/stroke_path.hpp"
#include "core/linear/pose.hpp"

namespace percussionist::sim {

class MovingNumber {
  public:
    explicit MovingNumber(double value = 0.0) : goal_(value) {}

    /// To be at `value` `time` after `now` [s].
    void go(double now, double value, double time) {
        const body::PathState from = moves(now) ? way_.at(now) : body::PathState{goal_, 0.0, 0.0};
        way_ = body::Quintic(now, from, now + time, {value, 0.0, 0.0});
        goal_ = value;
        end_ = now + time;
    }

    /// Valid from the last go() on.
    [[nodiscard]] double at(double t) const { return moves(t) ? way_.at(t).position : goal_; }
    [[nodiscard]] bool moves(double t) const { return t < end_; }
    [[nodiscard]] double goal() const { return goal_; }

  private:
    double goal_;
    double end_ = -1e9;
    body::Quintic way_;
};

class MovingPlace {
  public:
    explicit MovingPlace(const linear::Vector3& p = linear::Vector3::Zero())
        : coordinates_{MovingNumber(p.x()), MovingNumber(p.y()), MovingNumber(p.z())} {}

    void go(double now, const linear::Vector3& place, double time) {
        for (int i = 0; i < 3; ++i) coordinates_[i].go(now, place[i], time);
    }
    [[nodiscard]] linear::Vector3 at(double t) const {
        return {coordinates_[0].at(t), coordinates_[1].at(t), coordinates_[2].at(t)};
    }
    [[nodiscard]] linear::Vector3 goal() const {
        return {coordinates_[0].goal(), coordinates_[1].goal(), coordinates_[2].goal()};
    }

  private:
    std::array<MovingNumber, 3> coordinates_;
};

}  // namespace percussionist::sim
