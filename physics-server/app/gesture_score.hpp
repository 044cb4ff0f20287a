// A gesture score: what the strokes of a score become as movements of the tips, and whether the
// body can play them. Found by playing it, as fast as it can be simulated.
#pragma once

#include <filesystem>
#include <vector>

#include "app/performance.hpp"
#include "files/gesture_score_picture.hpp"

namespace percussionist::app {

/// A stroke and the movement that leads to it from the stroke before it of that hand.
struct GestureOfStroke {
    Asked asked;
    score::Stroke stroke;
    std::string gesture;         ///< its name
    double contact_error = 0.0;  ///< of the contact against the time asked for [s]
    bool struck = false;         ///< whether a contact came of it
    double raised = 0.0;         ///< the highest the tip was asked to be [m]
    double fastest = 0.0;        ///< the tip was asked to move [m/s]
    double acceleration = 0.0;   ///< the largest asked of it, outside contacts [m/s^2]
    double strained = 0.0;       ///< share of the time in which a joint was at its torque limit
    [[nodiscard]] bool playable() const;
};

struct PlayedScore {
    std::vector<GestureOfStroke> strokes;  ///< in order of time asked for
    /// Of the right and the left tip, asked for and made, every few ms; by Hand.
    std::array<files::Heights, 2> asked, made;
    std::vector<std::pair<double, double>> tempo;
};

/// Plays what is loaded, from its beginning.
PlayedScore play_through(Performance& performance);

/// strokes.csv, heights.csv and score-01.svg ..., `seconds` each. Throws std::runtime_error.
void write_gesture_score(const PlayedScore& score, const std::string& title, double seconds,
                         const std::filesystem::path& folder);

}  // namespace percussionist::app
