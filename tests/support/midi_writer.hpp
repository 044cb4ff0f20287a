// Builds MIDI files byte by byte, right or wrong on purpose.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace percussionist::test {

using Bytes = std::vector<std::uint8_t>;

inline void append(Bytes& to, const Bytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}

inline Bytes big_endian(std::uint32_t value, int bytes) {
    Bytes out;
    for (int i = bytes - 1; i >= 0; --i) {
        out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
    return out;
}

inline Bytes variable_length(std::uint32_t value) {
    Bytes out = {static_cast<std::uint8_t>(value & 0x7FU)};
    while ((value >>= 7U) != 0) {
        out.insert(out.begin(), static_cast<std::uint8_t>(0x80U | (value & 0x7FU)));
    }
    return out;
}

inline Bytes chunk(std::string_view name, const Bytes& content) {
    Bytes out(name.begin(), name.end());
    append(out, big_endian(static_cast<std::uint32_t>(content.size()), 4));
    append(out, content);
    return out;
}

/// The events of one track; `after` is ticks after the event before.
class Track {
  public:
    Track& raw(std::uint32_t after, const Bytes& event) {
        append(bytes_, variable_length(after));
        append(bytes_, event);
        return *this;
    }
    Track& note(std::uint32_t after, std::uint8_t key, std::uint8_t velocity = 64,
                std::uint8_t channel = 9) {
        return raw(after, {static_cast<std::uint8_t>(0x90 | channel), key, velocity});
    }
    Track& meta(std::uint32_t after, std::uint8_t type, const Bytes& content) {
        Bytes event = {0xFF, type};
        append(event, variable_length(static_cast<std::uint32_t>(content.size())));
        append(event, content);
        return raw(after, event);
    }
    Track& tempo(std::uint32_t after, std::uint32_t microseconds) {
        return meta(after, 0x51, big_endian(microseconds, 3));
    }
    Track& metre(std::uint32_t after, std::uint8_t beats, std::uint8_t power_of_two) {
        return meta(after, 0x58, {beats, power_of_two, 24, 8});
    }
    Track& exclusive(std::uint32_t after, const Bytes& content) {
        Bytes event = {0xF0};
        append(event, variable_length(static_cast<std::uint32_t>(content.size())));
        append(event, content);
        return raw(after, event);
    }
    /// Roland GS: the part whose block number is `block` plays drums, or does not.
    Track& gs_drums(std::uint32_t after, std::uint8_t block, bool drums) {
        return exclusive(
            after, {0x41, 0x10, 0x42, 0x12, 0x40, static_cast<std::uint8_t>(0x10 | block), 0x15,
                    static_cast<std::uint8_t>(drums ? 1 : 0), 0, 0xF7});
    }
    Track& end(std::uint32_t after = 0) { return meta(after, 0x2F, {}); }

    [[nodiscard]] const Bytes& bytes() const { return bytes_; }

  private:
    Bytes bytes_;
};

inline Bytes midi_file(int format, std::uint16_t division, const std::vector<Track>& tracks) {
    Bytes header = big_endian(static_cast<std::uint32_t>(format), 2);
    append(header, big_endian(static_cast<std::uint32_t>(tracks.size()), 2));
    append(header, big_endian(division, 2));
    Bytes out = chunk("MThd", header);
    for (const Track& track : tracks) {
        append(out, chunk("MTrk", track.bytes()));
    }
    return out;
}

/// A file with something of everything, for what damages files to start from.
inline Bytes rich_midi_file(int format) {
    Track conductor;
    conductor.meta(0, 0x03, {'R', 'i', 'c', 'h'})
        .metre(0, 6, 3)
        .tempo(0, 400000)
        .tempo(960, 300000);
    conductor.end(10);
    Track drums;
    drums.gs_drums(0, 1, true).note(0, 36).raw(120, {38, 100}).raw(120, {38, 0});
    drums.note(0, 42, 30, 0).raw(0, {0xC9, 1}).raw(0, {0xE9, 0, 64}).note(480, 49, 127);
    drums.raw(5, {0xF7, 2, 1, 2}).note(1, 38).end();
    Track melody;
    melody.note(0, 60, 80, 1).raw(480, {60, 0}).gs_drums(0, 1, false).end();
    return midi_file(format, 480, {conductor, drums, melody});
}

}  // namespace percussionist::test
