// Axes of a chart that hold all of its points.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "files/plot.hpp"

namespace percussionist::app {

/// Sets both axes' ends; up and down a margin is left.
inline void fit_axes(files::Chart& chart) {
    constexpr double kMargin = 0.05;
    const auto fit = [&](files::Axis& axis, const auto& coordinate, double margin) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const files::Series& series : chart.series) {
            for (const auto& point : series.points) {
                const double value = coordinate(point);
                if (!std::isfinite(value)) continue;
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
        if (!(low <= high)) return;
        const double size = std::max(high - low, 1e-6);
        axis.low = low - margin * size;
        axis.high = high + margin * size;
    };
    fit(
        chart.x, [](const auto& p) { return p.first; }, 0.0);
    fit(
        chart.y, [](const auto& p) { return p.second; }, kMargin);
}

}  // namespace percussionist::app
