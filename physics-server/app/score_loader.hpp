// From a file to the strokes of two hands, with what was left out and why, in words.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/score/stroke_plan.hpp"

namespace percussionist::app {

/// A score's file as it was read; no name: the built-in score.
struct ScoreSource {
    std::string name;
    std::vector<char> bytes;
};

struct LoadedScore {
    std::string title;
    std::size_t notes = 0;
    std::vector<score::Stroke> strokes;
    std::vector<std::string> remarks;  ///< warnings of the reader, each note left out
    ScoreSource source;
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

/// A Standard MIDI File, MusicXML, or a recording, whose drums are played; the built-in score if
/// `path` is empty. Throws files::MidiError files::MusicXmlError or files::AudioError.
LoadedScore load_score(const std::filesystem::path& path);

/// The same from a file's bytes.
LoadedScore load_kept_score(const ScoreSource& source);

/// The file `name` inside `folder`, or an error: std::runtime_error if it lies outside or is not
/// there. An empty name, or "built-in", is the built-in score (an empty path).
std::filesystem::path score_in_folder(const std::filesystem::path& folder, const std::string& name);

}  // namespace percussionist::app
