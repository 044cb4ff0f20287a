// The gestures that are built in and those a person added, kept in a text file: a line a gesture,
//     NAME RISE_m PEAK_DOWN_m_s IMPACT_m_s PEAK_UP_m_s REBOUND_m  SOURCE
// "#" begins a comment.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "body/gesture.hpp"

namespace percussionist::app {

/// The built-in ones, then those of the file (none if it is not there); of equal names the file's
/// counts. Throws std::runtime_error naming file, line and what was expected.
std::vector<body::Gesture> load_gestures(const std::filesystem::path& library);

/// Adds a line. Throws std::runtime_error, also for a name that is not one word.
void add_gesture(const std::filesystem::path& library, const body::Gesture& gesture);

/// The strokes in recordings of a left and a right stick, or of one. Throws std::runtime_error.
body::Gesture gesture_from_files(const std::string& name,
                                 const std::vector<std::filesystem::path>& files,
                                 double frame_rate);

}  // namespace percussionist::app
