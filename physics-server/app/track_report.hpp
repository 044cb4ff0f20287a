// What came of following a clip: tables, time series as CSV, pictures as SVG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/tracking.hpp"

namespace percussionist::app {

/// A line a run: errors, torques, computing time.
std::string track_table(const std::vector<TrackRun>& runs);

/// Into a folder: summary.csv, report.txt, a CSV a run, and pictures of elbow flexion, tip paths,
/// errors and torques. Throws std::runtime_error naming the file that cannot be written.
void write_track_report(const std::filesystem::path& folder, const LoadedClip& clip,
                        const TrackOptions& options, const std::vector<TrackRun>& runs);

}  // namespace percussionist::app
