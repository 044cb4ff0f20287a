// The strokes in a recording of a tip's height, and the numbers of each: as built-in gestures have
// them.
//
// A stroke is a low point at which the tip turns from falling to rising. Its rise is the highest
// point of the 0.4 s before it, its rebound that of the 0.4 s after, both above the low point;
// speeds are the largest in these times; the speed of the impact is the mean of the last 16 ms.
#pragma once

#include <vector>

#include "body/gesture.hpp"

namespace percussionist::body {

/// Heights [m] at a constant distance in time [s].
struct HeightSeries {
    double dt = 0.004;
    std::vector<double> heights;
};

/// Indices of the low points, so far apart [s]: with less than what follows below takes its time,
/// numbers of one stroke are partly those of its neighbours.
std::vector<std::size_t> find_strokes(const HeightSeries& series, double apart = 0.25);

StrokeShape measure_stroke(const HeightSeries& series, std::size_t low);

/// Number by number. Throws std::invalid_argument for none.
StrokeShape median_shape(const std::vector<StrokeShape>& shapes);

}  // namespace percussionist::body
