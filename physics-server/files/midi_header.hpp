// The header chunk of a MIDI file: its format, its tracks, its unit of time.
#pragma once

#include <string>

#include "core/score/tempo_map.hpp"
#include "files/byte_reader.hpp"

namespace percussionist::files {

struct MidiHeader {
    int format = 0;
    int tracks = 0;  ///< as it says
    score::TickDivision division;
    std::string warning;  ///< what was wrong with it, if anything
};

/// Leaves the reader at the first chunk after the header. Throws UnexpectedByte.
MidiHeader read_header(ByteReader& reader);

}  // namespace percussionist::files
