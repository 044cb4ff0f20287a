// MusicXML, what notation programs export: bytes in, a score out.
//
// Reads score-partwise (3.x and 4.0), plain or compressed (.mxl): all parts together, durations and
// chords, backup and forward, repeats with endings, time signatures, tempo marks (with accelerando
// and ritardando between two of them), dynamics and hairpins, unpitched instruments by their MIDI
// number. Articulations are nuances: accent -> accent, strong accent -> vertical accent,
// staccato -> staccato, staccatissimo -> piston, tenuto -> tenuto. Tremolos become the strokes they
// stand for; grace notes stand before their note, closer than any beat (flam, drag, ruff).
//
// By way of pugixml. Throws MusicXmlError with one line: file, place, what was expected.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

#include "core/score/score.hpp"

namespace percussionist::files {

/// what(): "song.musicxml: line 3: expected ..., found ..."
struct MusicXmlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// `name` is what errors call the file.
score::Score parse_musicxml(std::span<const char> bytes, std::string_view name);

/// Also for a file that cannot be opened or is above 16 MB.
score::Score read_musicxml_file(const std::filesystem::path& path);

}  // namespace percussionist::files
