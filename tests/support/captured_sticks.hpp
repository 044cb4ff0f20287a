// Two sticks that strike in turn in the air, as they are captured: synthetic. Where they turn
// wanders up and down, as it does with no drum to end a stroke.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "body/stick_motion.hpp"

namespace percussionist::test {

struct CapturedSticks {
    double apart = 0.3;        ///< from stroke to stroke, left and right in turn [s]
    int strokes = 16;          ///< the first at `apart`
    double rise = 0.25;        ///< [m]
    double wanders = 0.02;     ///< of the height of a turn, up and down [m]
    double frequency = 250.0;  ///< of capturing [Hz]

    [[nodiscard]] double time(int stroke) const { return apart * (stroke + 1); }

    [[nodiscard]] std::shared_ptr<const body::Clip> clip(const body::Skeleton& skeleton) const {
        std::array<std::optional<motion::Trajectory>, 2> paths;
        for (int h = 0; h < 2; ++h) {
            motion::Trajectory& path = paths[h].emplace();
            path.name = h == 0 ? "left" : "right";
            for (double t = 0.0; t < time(strokes); t += 1.0 / frequency) {
                const double phase = (t - time(h)) / (2.0 * apart);
                const double height = rise * std::abs(std::sin(std::numbers::pi * phase)) +
                                      wanders * std::sin(1.9 * t + h);
                path.samples.push_back({t, {0.6, h == 0 ? 0.08 : -0.08, 0.9 + height}});
            }
        }
        return body::follow_sticks("synthetic", skeleton, paths).clip;
    }
};

}  // namespace percussionist::test
