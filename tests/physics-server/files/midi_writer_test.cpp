#include "files/midi_writer.hpp"

#include <doctest/doctest.h>

#include "files/midi_file.hpp"

using namespace percussionist;
using namespace percussionist::files;

namespace {

MidiFile groove() {
    MidiFile file;
    file.title = "A groove";
    file.division.ticks_per_quarter = 960;
    file.tempos = {{0, 0.5}, {3840, 0.45}};
    file.metres = {{0, 3, 4}, {2880, 6, 8}};
    file.notes = {{0, 36, 100, 9, true},
                  {0, 42, 1, 9, true},
                  {10, 42, 127, 9, true},
                  {5000, 38, 64, 9, true}};
    return file;
}

}  // namespace

TEST_CASE("what is written reads back as it was") {
    const MidiFile file = groove();
    const MidiFile again = parse_midi(midi_bytes(file), "groove");
    CHECK(again.warnings.empty());
    CHECK(again.title == file.title);
    CHECK(again.division.ticks_per_quarter == 960);
    REQUIRE(again.notes.size() == file.notes.size());
    for (std::size_t n = 0; n < file.notes.size(); ++n) {
        CHECK(again.notes[n].tick == file.notes[n].tick);
        CHECK(again.notes[n].key == file.notes[n].key);
        CHECK(again.notes[n].velocity == file.notes[n].velocity);
        CHECK(again.notes[n].percussion);
    }
    REQUIRE(again.tempos.size() == 2);
    CHECK(again.tempos[1].tick == 3840);
    CHECK(again.tempos[1].seconds_per_quarter == doctest::Approx(0.45));
    REQUIRE(again.metres.size() == 2);
    CHECK(again.metres[1].beats == 6);
    CHECK(again.metres[1].beat_unit == 8);
}

TEST_CASE("what MIDI cannot say is refused") {
    MidiFile file = groove();
    file.notes[1].velocity = 0;
    CHECK_THROWS_AS(midi_bytes(file), MidiError);
    file = groove();
    file.tempos[0].seconds_per_quarter = 20.0;
    CHECK_THROWS_AS(midi_bytes(file), MidiError);
    file = groove();
    file.notes[0].tick = -1;
    CHECK_THROWS_AS(midi_bytes(file), MidiError);
    CHECK_THROWS_AS(write_midi_file("/nowhere/at/all.mid", groove()), MidiError);
}
