#include "files/midi_writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>

namespace percussionist::files {

namespace {

using Bytes = std::vector<std::uint8_t>;
using score::Tick;

constexpr double kNoteQuarters = 0.125;  ///< a drum's note is held
constexpr Tick kLatest = 0x0FFFFFFF;     ///< the longest time between events MIDI can say

void expect(bool holds, const std::string& what) {
    if (!holds) throw MidiError("MIDI: expected " + what);
}

void append(Bytes& to, const Bytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}

Bytes big_endian(std::uint32_t value, int bytes) {
    Bytes out;
    for (int i = bytes - 1; i >= 0; --i)
        out.push_back(static_cast<std::uint8_t>(value >> (8U * static_cast<unsigned>(i))));
    return out;
}

Bytes variable_length(Tick ticks) {
    auto value = static_cast<std::uint32_t>(ticks);
    Bytes out = {static_cast<std::uint8_t>(value & 0x7FU)};
    while ((value >>= 7U) != 0)
        out.insert(out.begin(), static_cast<std::uint8_t>(0x80U | (value & 0x7FU)));
    return out;
}

Bytes meta(std::uint8_t type, const Bytes& content) {
    Bytes event = {0xFF, type};
    append(event, variable_length(static_cast<Tick>(content.size())));
    append(event, content);
    return event;
}

struct Event {
    Tick tick = 0;
    int rank = 0;  ///< of what happens at one tick, the lower comes first
    Bytes bytes;
};

Event event_of(const score::TempoChange& change) {
    const double microseconds = std::round(1e6 * change.seconds_per_quarter);
    expect(microseconds >= 1.0 && microseconds <= 0xFFFFFF, "a quarter note of 1 us to 16.7 s");
    return {change.tick, 1, meta(0x51, big_endian(static_cast<std::uint32_t>(microseconds), 3))};
}

Event event_of(const score::MetreChange& change) {
    const auto unit = static_cast<unsigned>(change.beat_unit);
    expect(change.beats >= 1 && change.beats <= 255 && std::has_single_bit(unit),
           "a metre such as 4/4");
    const auto power = static_cast<std::uint8_t>(std::countr_zero(unit));
    return {change.tick, 0, meta(0x58, {static_cast<std::uint8_t>(change.beats), power, 24, 8})};
}

/// When a note ends: before the next of its key.
Tick end_of(const MidiFile& file, std::size_t note) {
    const MidiNote& held = file.notes[note];
    Tick end =
        held.tick +
        std::max<Tick>(1, static_cast<Tick>(kNoteQuarters * file.division.ticks_per_quarter));
    for (std::size_t next = note + 1; next < file.notes.size() && file.notes[next].tick < end;
         ++next) {
        const MidiNote& other = file.notes[next];
        if (other.key == held.key && other.channel == held.channel)
            end = std::max(held.tick, other.tick);
    }
    return end;
}

void add_note(const MidiFile& file, std::size_t n, std::vector<Event>& events) {
    const MidiNote& note = file.notes[n];
    expect(note.key >= 0 && note.key <= 127 && note.velocity >= 1 && note.velocity <= 127 &&
               note.channel >= 0 && note.channel <= 15,
           "a key of 0 to 127, a velocity of 1 to 127 and a channel of 0 to 15");
    const auto channel = static_cast<std::uint8_t>(note.channel);
    const auto key = static_cast<std::uint8_t>(note.key);
    events.push_back({note.tick,
                      3,
                      {static_cast<std::uint8_t>(0x90U | channel), key,
                       static_cast<std::uint8_t>(note.velocity)}});
    events.push_back({end_of(file, n), 2, {static_cast<std::uint8_t>(0x80U | channel), key, 64}});
}

Bytes track_of(std::vector<Event> events) {
    std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
        return std::pair(a.tick, a.rank) < std::pair(b.tick, b.rank);
    });
    Bytes track;
    Tick now = 0;
    for (const Event& event : events) {
        expect(event.tick >= now && event.tick - now <= kLatest,
               "ticks from 0 on, events not too far apart");
        append(track, variable_length(event.tick - now));
        append(track, event.bytes);
        now = event.tick;
    }
    append(track, {0});
    append(track, meta(0x2F, {}));
    return track;
}

Bytes chunk(const char* name, const Bytes& content) {
    Bytes out(name, name + 4);
    append(out, big_endian(static_cast<std::uint32_t>(content.size()), 4));
    append(out, content);
    return out;
}

}  // namespace

std::vector<std::uint8_t> midi_bytes(const MidiFile& file) {
    const double division = file.division.ticks_per_quarter;
    expect(file.division.ticks_per_second == 0.0 && division >= 1.0 && division <= 32767.0,
           "1 to 32767 ticks a quarter note");
    std::vector<Event> events = {{0, -1, meta(0x03, Bytes(file.title.begin(), file.title.end()))}};
    for (const auto& change : file.metres) events.push_back(event_of(change));
    for (const auto& change : file.tempos) events.push_back(event_of(change));
    for (std::size_t n = 0; n < file.notes.size(); ++n) add_note(file, n, events);
    Bytes header = {0, 0, 0, 1};
    append(header, big_endian(static_cast<std::uint32_t>(division), 2));
    Bytes bytes = chunk("MThd", header);
    append(bytes, chunk("MTrk", track_of(std::move(events))));
    return bytes;
}

void write_midi_file(const std::filesystem::path& path, const MidiFile& file) {
    const Bytes bytes = midi_bytes(file);
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw MidiError(path.string() + ": cannot be written");
}

}  // namespace percussionist::files
