#include "body/stroke_measure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percussionist::body {

namespace {

constexpr double kWindow = 0.40;         // [s]
constexpr double kImpactWindow = 0.016;  // [s]
/// A stroke falls into its low point and rises out of it at least so far within 60 ms [m], and lies
/// in the lowest fifth of the motion.
constexpr double kTurn = 0.02;
constexpr double kTurnTime = 0.06;
constexpr double kLowest = 0.2;

std::ptrdiff_t samples(double time, double dt) {
    return std::max<std::ptrdiff_t>(1, std::lround(time / dt));
}

}  // namespace

std::vector<std::size_t> find_strokes(const HeightSeries& series, double apart) {
    std::vector<std::size_t> lows;
    const std::vector<double>& z = series.heights;
    if (z.size() < 3) return lows;
    const auto [least, most] = std::minmax_element(z.begin(), z.end());
    const double low_enough = *least + kLowest * (*most - *least);
    const auto around = static_cast<std::size_t>(samples(kTurnTime, series.dt));
    const auto least_apart = static_cast<std::size_t>(samples(apart, series.dt));
    for (std::size_t i = around; i + around < z.size(); ++i) {
        const auto before = z.begin() + static_cast<std::ptrdiff_t>(i - around);
        const auto after = z.begin() + static_cast<std::ptrdiff_t>(i + around);
        const bool lowest = *std::min_element(before, after + 1) == z[i];
        if (!lowest || z[i] > low_enough || *before - z[i] < kTurn || *after - z[i] < kTurn) {
            continue;
        }
        if (lows.empty() || i - lows.back() >= least_apart) lows.push_back(i);
    }
    return lows;
}

StrokeShape measure_stroke(const HeightSeries& series, std::size_t low) {
    const std::vector<double>& z = series.heights;
    const auto at = static_cast<std::ptrdiff_t>(low);
    const auto window = samples(kWindow, series.dt);
    const auto last = static_cast<std::ptrdiff_t>(z.size()) - 1;
    StrokeShape s{0.0, 0.0, 0.0, 0.0, 0.0};
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, at - window); i < at; ++i) {
        s.rise = std::max(s.rise, z[i] - z[low]);
        s.peak_down = std::max(s.peak_down, (z[i] - z[i + 1]) / series.dt);
    }
    for (std::ptrdiff_t i = at; i < std::min(last, at + window); ++i) {
        s.rebound = std::max(s.rebound, z[i + 1] - z[low]);
        s.peak_up = std::max(s.peak_up, (z[i + 1] - z[i]) / series.dt);
    }
    const auto back = std::min(at, samples(kImpactWindow, series.dt));
    if (back > 0) {
        s.impact = (z[at - back] - z[low]) / (static_cast<double>(back) * series.dt);
    }
    return s;
}

StrokeShape median_shape(const std::vector<StrokeShape>& shapes) {
    if (shapes.empty()) throw std::invalid_argument("strokes: expected some, found none");
    const auto median = [&](double StrokeShape::*number) {
        std::vector<double> values;
        for (const StrokeShape& s : shapes) values.push_back(s.*number);
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        return values[values.size() / 2];
    };
    return {median(&StrokeShape::rise), median(&StrokeShape::peak_down),
            median(&StrokeShape::impact), median(&StrokeShape::peak_up),
            median(&StrokeShape::rebound)};
}

}  // namespace percussionist::body
