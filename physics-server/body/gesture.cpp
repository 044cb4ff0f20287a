#include "body/gesture.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percussionist::body {

const std::vector<Gesture>& built_in_gestures() {
    static const std::vector<Gesture> gestures = [] {
        const std::string source = "synthetic: medians of timpanists' strokes";
        return std::vector<Gesture>{
            {"legato", {0.40, 2.4, 1.9, 2.4, 0.43}, true, source},
            {"tenuto", {0.52, 3.3, 2.8, 1.9, 0.36}, true, source},
            {"accent", {0.42, 3.4, 2.8, 3.5, 0.47}, true, source},
            {"vertical-accent", {0.56, 4.8, 4.4, 2.5, 0.35}, true, source},
            {"staccato", {0.42, 2.3, 0.9, 3.3, 0.58}, true, source},
            {"piston", {0.20, 4.7, 4.4, 3.3, 0.41}, true, source},
        };
    }();
    return gestures;
}

const Gesture* find_gesture(const std::vector<Gesture>& gestures, const std::string& name) {
    const auto found = std::find_if(gestures.begin(), gestures.end(),
                                    [&](const Gesture& g) { return g.name == name; });
    return found == gestures.end() ? nullptr : &*found;
}

StrokeShape scaled(const StrokeShape& shape, double factor) {
    const double height = factor < 1.0 ? factor : std::pow(factor, 0.4);
    return {shape.rise * height, shape.peak_down * factor, shape.impact * factor,
            shape.peak_up * factor, shape.rebound * height};
}

double drum_position(const std::string& name) {
    if (name == "centre") return 0.15;
    if (name == "third") return 0.55;
    if (name == "rim") return 0.75;
    throw std::invalid_argument("drum position: expected centre, third or rim, got '" + name + "'");
}

}  // namespace percussionist::body
