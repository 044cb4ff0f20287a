// From a file to the strokes of two hands, with what was left out and why, in words. A captured
// motion is a score too: its strokes are those found in it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "body/playable_clip.hpp"
#include "core/score/stroke_plan.hpp"

namespace percussionist::app {

/// A score's file as it was read; no name: the built-in score.
struct ScoreSource {
    std::string name;
    std::vector<char> bytes;
};

/// A recorded movement that the percussionist plays as it was made.
struct CapturedMotion {
    CapturedMotion(std::shared_ptr<const body::Clip> captured, const body::Skeleton& skeleton,
                   std::vector<body::JointLimits> wide)
        : clip(std::move(captured), skeleton), limits(std::move(wide)) {}
    body::PlayableClip clip;
    std::vector<body::JointLimits> limits;  ///< by segment: the usual ones, wide enough for it
};

struct LoadedScore {
    std::string title;
    std::size_t notes = 0;
    std::vector<score::Stroke> strokes;
    std::vector<std::string> remarks;  ///< warnings of the reader, each note left out
    ScoreSource source;
    std::shared_ptr<const CapturedMotion> motion;  ///< null of all but captured motion
};

/// "TITLE: 12 of 13 notes", of a LoadedScore or a KitScore.
template <class Loaded>
std::string in_brief(const Loaded& score) {
    return score.title + ": " + std::to_string(score.strokes.size()) + " of " +
           std::to_string(score.notes) + " notes";
}

/// What is said of a score that will be played; remarks beyond the first 50 are counted.
void print_account(const std::string& brief, const std::vector<std::string>& remarks);

/// By its name, a recording of sound.
bool is_recording(const std::filesystem::path& path);

/// The notes alone; warnings of the reader are added to `warnings`. As load_score().
score::Score read_score(const std::filesystem::path& path, std::vector<std::string>& warnings);

/// By its name, motion capture of a body (BVH) or of sticks (CSV).
bool is_motion(const std::filesystem::path& path);

/// A Standard MIDI File, MusicXML, a recording, whose drums are played, or a captured motion, as
/// that `person` plays it; the built-in score if `path` is empty. Throws files::MidiError,
/// files::MusicXmlError, files::AudioError, or std::runtime_error of a motion.
LoadedScore load_score(const std::filesystem::path& path, const body::Anthropometry& person = {});

/// The same from a file's bytes.
LoadedScore load_kept_score(const ScoreSource& source, const body::Anthropometry& person = {});

/// The file `name` inside `folder`, or an error: std::runtime_error if it lies outside or is not
/// there. An empty name, or "built-in", is the built-in score (an empty path).
std::filesystem::path score_in_folder(const std::filesystem::path& folder, const std::string& name);

}  // namespace percussionist::app
