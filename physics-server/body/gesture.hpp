// The gestures of a percussionist: how a nuance moves the tip of the stick.
//
// A stroke is told by five numbers: the height the tip is raised to before it, its largest speed
// down, its speed when it strikes, its largest speed up after it, the height it comes back to. The
// built-in ones are synthetic: made from medians over 204 strokes of timpanists at 250 Hz, not
// recorded. Others come from recordings, see stroke_measure.hpp.
//
// Values; any thread.
#pragma once

#include <string>
#include <vector>

namespace percussionist::body {

struct StrokeShape {
    double rise = 0.40;      ///< of the tip above the head, before the stroke [m]
    double peak_down = 2.4;  ///< largest speed down [m/s]
    double impact = 1.9;     ///< speed when it strikes [m/s]
    double peak_up = 2.4;    ///< largest speed up, after the stroke [m/s]
    double rebound = 0.43;   ///< height it comes back to [m]
};

enum class Grip { french, german };

struct Gesture {
    std::string name;
    StrokeShape shape;
    bool synthetic = true;  ///< built from numbers, not recorded
    std::string source;     ///< where it comes from, in words
};

/// legato, tenuto, accent, vertical-accent, staccato, piston.
const std::vector<Gesture>& built_in_gestures();

/// Null if there is none of that name.
const Gesture* find_gesture(const std::vector<Gesture>& gestures, const std::string& name);

/// The same gesture for a stroke `factor` times as fast: softer ones are smaller, harder ones
/// hardly higher, as score::preparation_height() has it.
StrokeShape scaled(const StrokeShape& shape, double factor);

/// Where on the head: share of its radius by name (centre, third, rim); throws
/// std::invalid_argument naming what there is.
double drum_position(const std::string& name);

}  // namespace percussionist::body
