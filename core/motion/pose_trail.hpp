// Where something was lately, at any instant: the last positions, joined by straight lines.
//
// Before the first and after the last it stands still. Straight lines never overshoot; they lag
// nothing, and leave out of a hand's curve at most a dt^2 / 8 (a in m/s^2: 20 at 120 Hz, 0.2 mm).
// No allocation; real-time safe; one thread.
#pragma once

#include <array>
#include <cstddef>

#include "core/linear/pose.hpp"

namespace percussionist::motion {

class PoseTrail {
  public:
    /// In order of time; what is not later than the last is dropped.
    void add(double time, const linear::Vector3& position) noexcept {
        if (count_ > 0 && time <= newest(0).time) {
            return;
        }
        points_[count_++ % kLength] = {time, position};
    }

    linear::Vector3 position(double time) const noexcept {
        const std::size_t known = count_ < kLength ? count_ : kLength;
        if (known == 0) {
            return linear::Vector3::Zero();
        }
        for (std::size_t i = 0; i < known; ++i) {
            if (time < newest(i).time) {
                continue;
            }
            if (i == 0) {
                return newest(0).position;
            }
            const Point &before = newest(i), &after = newest(i - 1);
            const double part = (time - before.time) / (after.time - before.time);
            return before.position + part * (after.position - before.position);
        }
        return newest(known - 1).position;
    }

    void clear() noexcept { count_ = 0; }

  private:
    static constexpr std::size_t kLength = 64;
    struct Point {
        double time = 0.0;
        linear::Vector3 position = linear::Vector3::Zero();
    };
    const Point& newest(std::size_t back) const noexcept {
        return points_[(count_ - 1 - back) % kLength];
    }
    std::array<Point, kLength> points_{};
    std::size_t count_ = 0;
};

}  // namespace percussionist::motion
