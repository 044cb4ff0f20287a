// Standard MIDI Files: plain values in, bytes out. What is written reads back as it was.
//
// One track (format 0) with title, metres, tempos and notes. Drums of General MIDI take no notice
// of how long a note is held: each lasts a short while, less if the next of its key comes sooner.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "files/midi_file.hpp"

namespace percussionist::files {

/// Of file.title, division, tempos, metres and notes; the rest does not count. Throws MidiError
/// for what MIDI cannot say: a key or velocity out of range, a tempo above 16.7 s a quarter note,
/// ticks below 0, SMPTE time.
std::vector<std::uint8_t> midi_bytes(const MidiFile& file);

/// Throws MidiError, also where the file cannot be written.
void write_midi_file(const std::filesystem::path& path, const MidiFile& file);

}  // namespace percussionist::files
