#include "files/midi_header.hpp"

namespace percussionist::files {

namespace {

constexpr std::size_t kKnownBytes = 6;

score::TickDivision read_division(ByteReader& reader) {
    score::TickDivision division;
    const std::size_t at = reader.at();
    const unsigned high = reader.u8();
    const unsigned low = reader.u8();
    if (high < 0x80) {
        if (high == 0 && low == 0) {
            throw UnexpectedByte(at, "expected ticks in a quarter note, found 0");
        }
        division.ticks_per_quarter = high << 8U | low;
        return division;
    }
    const unsigned frames = 256 - high;
    if (frames != 24 && frames != 25 && frames != 29 && frames != 30) {
        throw UnexpectedByte(at, "expected SMPTE time of 24, 25, 29 or 30 frames a second, found " +
                                     std::to_string(frames));
    }
    if (low == 0) {
        throw UnexpectedByte(at + 1, "expected ticks in a SMPTE frame, found 0");
    }
    // 29 stands for drop-frame time, whose frames last 1.001/30 s.
    division.ticks_per_second = low * (frames == 29 ? 30.0 / 1.001 : frames);
    return division;
}

bool chunk_at(const ByteReader& reader, std::size_t at) {
    return at <= reader.bytes().size() && reader.part(at, reader.bytes().size()).comes("MTrk");
}

/// Headers may grow. One whose length leads nowhere, with a track right after the six bytes that
/// are known, is wrong.
void skip_rest(ByteReader& reader, std::size_t length, MidiHeader& header) {
    const std::size_t known = reader.at();
    const std::size_t end = known - kKnownBytes + length;
    if (end != known && !chunk_at(reader, end) && chunk_at(reader, known)) {
        header.warning = "byte 4: the header says that it has " + std::to_string(length) +
                         " bytes, and it has 6";
        return;
    }
    reader.take(end - known);
}

}  // namespace

MidiHeader read_header(ByteReader& reader) {
    if (!reader.comes("MThd")) {
        throw reader.expected("a header chunk 'MThd'");
    }
    reader.take(4);
    const std::size_t length = reader.u32();
    const std::size_t start = reader.at();
    if (length < kKnownBytes) {
        throw UnexpectedByte(
            start - 4, "expected a header of at least 6 bytes, found " + std::to_string(length));
    }
    MidiHeader header;
    header.format = static_cast<int>(reader.u16());
    if (header.format > 2) {
        throw UnexpectedByte(start,
                             "expected format 0, 1 or 2, found " + std::to_string(header.format));
    }
    header.tracks = static_cast<int>(reader.u16());
    header.division = read_division(reader);
    skip_rest(reader, length, header);
    return header;
}

}  // namespace percussionist::files
