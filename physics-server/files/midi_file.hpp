// Standard MIDI Files: bytes in, plain values out.
//
// Reads formats 0, 1 and 2, RIFF RMID wrappers, running status, system exclusive, alien chunks,
// ticks a quarter note and SMPTE time, tempo changes in any track. A file that is cut or
// miscounted is read as far as it goes, with a warning; one that cannot be understood gives one
// MidiError with file, byte and what was expected there. No byte sequence may crash it, and it
// takes memory only in proportion to the bytes that are there, never by what they claim.
//
// Percussion is channel 10, and those parts a Roland GS message (sysex 40 1x 15) makes
// drums. The sequences of format 2, which are independent, are laid one after another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/score/score.hpp"

namespace percussionist::files {

/// what(): "song.mid: byte 14: expected a track chunk 'MTrk', found 'MXrk'"
struct MidiError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct MidiNote {
    score::Tick tick = 0;
    int key = 0;              ///< 0..127
    int velocity = 0;         ///< 1..127
    int channel = 0;          ///< 0..15
    bool percussion = false;  ///< on a drum part when it sounded
};

struct MidiFile {
    std::string name;   ///< of the file
    std::string title;  ///< what the first track calls itself, if it does
    int format = 0;
    int tracks = 0;  ///< that were there
    score::TickDivision division;
    std::vector<MidiNote> notes;  ///< in order of time
    std::vector<score::TempoChange> tempos;
    std::vector<score::MetreChange> metres;
    score::Tick end = 0;                ///< of the longest track
    std::vector<std::string> warnings;  ///< what was wrong and read all the same
};

/// `name` is what errors call the file. Throws MidiError.
MidiFile parse_midi(std::span<const std::uint8_t> bytes, std::string_view name);

/// Throws MidiError, also for a file that cannot be opened or is above 16 MB.
MidiFile read_midi_file(const std::filesystem::path& path);

/// The percussion notes in seconds; all notes if none is percussion (a warning said so).
score::Score midi_to_score(const MidiFile& file);

}  // namespace percussionist::files
