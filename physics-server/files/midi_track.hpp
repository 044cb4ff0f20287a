// The events of one MIDI track: what midi_file.hpp makes a file of.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/byte_reader.hpp"
#include "files/midi_file.hpp"

namespace percussionist::files {

/// From here on a part plays drums, or does not.
struct DrumPart {
    score::Tick tick = 0;
    int channel = -1;  ///< -1: all parts as at the start, channel 10 alone
    bool drums = false;
};

struct MidiTrack {
    std::string name;
    std::vector<MidiNote> notes;
    std::vector<score::TempoChange> tempos;
    std::vector<score::MetreChange> metres;
    std::vector<DrumPart> drum_parts;
    score::Tick end = 0;
    bool has_end = false;                   ///< its end-of-track event was there
    std::vector<UnexpectedByte> oddities;   ///< left out, the rest was read
    std::optional<UnexpectedByte> stopped;  ///< why the rest could not be read
};

/// Reads events until the end of the track or of the bytes; ticks count from `start`. Never throws
/// for what the bytes say.
MidiTrack read_track(ByteReader& reader, score::Tick start);

}  // namespace percussionist::files
