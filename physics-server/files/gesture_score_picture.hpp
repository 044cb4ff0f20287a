// A musical score over the gestures that play it: notes on a line with their marks, and under them
// the heights of both sticks' tips, all along one time (figure 5 of Bouenard, Gibet, Wanderley
// 2009). As SVG text; the same score gives the same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/score/nuance.hpp"

namespace percussionist::files {

struct PicturedNote {
    double time = 0.0;  ///< at which it sounds [s]
    int hand = 1;       ///< 0 left, 1 right
    score::Nuance nuance = score::Nuance::legato;
    int bar = 1;
    bool played = true;
};

/// [s], [m]
using Heights = std::vector<std::pair<double, double>>;

struct GestureScore {
    std::string title;
    double from = 0.0, to = 10.0;  ///< what is shown [s]
    std::vector<PicturedNote> notes;
    Heights right_asked, right, left_asked, left;
    std::vector<std::pair<double, double>> tempo;  ///< [s], factor; drawn where it changes
};

std::string svg(const GestureScore& score);

/// Throws std::runtime_error naming the file.
void write_svg(const std::filesystem::path& path, const GestureScore& score);

}  // namespace percussionist::files
