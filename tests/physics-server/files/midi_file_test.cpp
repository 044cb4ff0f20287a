#include "files/midi_file.hpp"

#include <doctest/doctest.h>

#include <string>

#include "support/midi_writer.hpp"

using namespace percussionist;
using namespace percussionist::files;
using test::Bytes;
using test::Track;

namespace {

MidiFile parse(const Bytes& bytes) {
    return parse_midi(bytes, "song.mid");
}

std::string error_of(const Bytes& bytes) {
    try {
        parse(bytes);
    } catch (const MidiError& error) {
        return error.what();
    }
    return "read";
}

bool warns(const MidiFile& file, const std::string& part) {
    for (const std::string& warning : file.warnings) {
        if (warning.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

const Track kOneNote = Track().note(0, 38, 100).end();

}  // namespace

TEST_CASE("a note has its tick, key, velocity and channel, and a sound file no warnings") {
    const MidiFile file = parse(test::midi_file(0, 96, {Track().note(200, 38, 100).end(4)}));
    REQUIRE(file.notes.size() == 1);
    CHECK(file.notes[0].tick == 200);
    CHECK(file.notes[0].key == 38);
    CHECK(file.notes[0].velocity == 100);
    CHECK(file.notes[0].channel == 9);
    CHECK(file.notes[0].percussion);
    CHECK(file.end == 204);
    CHECK(file.division.ticks_per_quarter == 96);
    CHECK(file.warnings.empty());
}

TEST_CASE("running status repeats the last channel message; velocity 0 is a note-off") {
    Track track;
    track.note(0, 36).raw(10, {38, 0}).raw(10, {42, 50}).meta(0, 0x01, {'x'}).raw(10, {44, 60});
    const MidiFile file = parse(test::midi_file(0, 96, {track.end()}));
    REQUIRE(file.notes.size() == 3);
    CHECK(file.notes[1].key == 42);
    CHECK(file.notes[2].tick == 30);
}

TEST_CASE("the tracks of format 1 sound together under the tempi of all of them") {
    const Track conductor = Track().tempo(0, 1000000).end();
    const Track first = Track().note(96, 36).tempo(96, 250000).end();
    const Track second = Track().note(96, 38).note(192, 42).end();
    const score::Score score =
        midi_to_score(parse(test::midi_file(1, 96, {conductor, first, second})));
    REQUIRE(score.notes.size() == 3);
    CHECK(score.notes[0].time == doctest::Approx(1.0));
    CHECK(score.notes[1].time == doctest::Approx(1.0));
    CHECK(score.notes[2].time == doctest::Approx(2.25));
    CHECK(score.duration == doctest::Approx(2.25));
}

TEST_CASE("the sequences of format 2 follow one another, each at its own tempo") {
    const Track first = Track().tempo(0, 250000).note(96, 36).end(96);
    const Track second = Track().note(96, 38).end();
    const MidiFile file = parse(test::midi_file(2, 96, {first, second}));
    const score::Score score = midi_to_score(file);
    CHECK(score.notes[0].time == doctest::Approx(0.25));
    CHECK(score.notes[1].time == doctest::Approx(0.5 + 0.5));
    CHECK(warns(file, "2 independent sequences"));
}

TEST_CASE("SMPTE ticks are parts of a frame, and drop-frame time is 29.97 frames a second") {
    const auto time_of_tick_1000 = [](std::uint8_t frames) {
        const auto division = static_cast<std::uint16_t>((256U - frames) << 8U | 40U);
        return midi_to_score(
                   parse(test::midi_file(0, division, {Track().tempo(0, 9).note(1000, 38).end()})))
            .notes.at(0)
            .time;
    };
    CHECK(time_of_tick_1000(24) == doctest::Approx(25.0 / 24));
    CHECK(time_of_tick_1000(25) == doctest::Approx(1.0));
    CHECK(time_of_tick_1000(29) == doctest::Approx(25.0 / 30 * 1.001));
    CHECK(time_of_tick_1000(30) == doctest::Approx(25.0 / 30));
}

TEST_CASE("bars and beats follow the time signatures") {
    const Track track =
        Track().metre(0, 3, 2).note(96 * 4, 38).metre(96 * 2, 6, 3).note(48, 38).end();
    const score::Score score = midi_to_score(parse(test::midi_file(0, 96, {track})));
    CHECK(score.notes[0].position.bar == 2);
    CHECK(score.notes[0].position.beat == doctest::Approx(2));
    CHECK(score.notes[1].position.bar == 3);
    CHECK(score.notes[1].position.beat == doctest::Approx(2));
}

TEST_CASE("a GS message makes a part drums from there on, until another takes it back") {
    // At one tick, in whatever track, it comes before the notes.
    Track track;
    track.note(0, 50, 64, 0).gs_drums(5, 1, true).note(10, 51, 64, 0);
    track.gs_drums(10, 1, false).note(10, 52, 64, 0);
    track.gs_drums(0, 0xF, true).note(10, 53, 64, 15).gs_drums(0, 0, false).note(10, 54, 64, 9);
    track.exclusive(5, {0x41, 0x10, 0x42, 0x12, 0x40, 0x00, 0x7F, 0x00, 0x41, 0xF7});
    track.note(10, 55, 64, 9).note(0, 56, 64, 15);
    const MidiFile file = parse(test::midi_file(0, 96, {track.end()}));
    std::vector<int> drums;
    for (const MidiNote& note : file.notes) {
        if (note.percussion) {
            drums.push_back(note.key);
        }
    }
    CHECK(drums == std::vector<int>{51, 53, 55});
    CHECK(midi_to_score(file).notes.size() == 3);
}

TEST_CASE("without percussion all notes are taken, saying so") {
    const MidiFile file =
        parse(test::midi_file(0, 96, {Track().note(0, 60, 64, 0).note(9, 62, 64, 3).end()}));
    CHECK(midi_to_score(file).notes.size() == 2);
    CHECK(warns(file, "no percussion channel: all 2 notes are taken"));
}

TEST_CASE("a title is what the first track calls itself, or the name of the file") {
    const Track named = Track().meta(0, 0x03, {'B', 'o', 7, 0x7F, 0x90, 'l'}).note(0, 38).end();
    CHECK(midi_to_score(parse(test::midi_file(0, 96, {named}))).title == "Bo???l");
    CHECK(midi_to_score(parse(test::midi_file(0, 96, {kOneNote}))).title == "song.mid");
}

TEST_CASE("what is not music is passed over: alien chunks, long headers, a RIFF around it") {
    const Bytes plain = test::midi_file(0, 96, {kOneNote});
    Bytes with_alien(plain.begin(), plain.begin() + 14);
    test::append(with_alien, test::chunk("XFIH", {1, 2, 3}));
    test::append(with_alien, {plain.begin() + 14, plain.end()});
    CHECK(parse(with_alien).notes.size() == 1);
    CHECK(parse(with_alien).warnings.empty());

    Bytes long_header = test::chunk("MThd", {0, 0, 0, 1, 0, 96, 9, 9, 9, 9});
    test::append(long_header, test::chunk("MTrk", kOneNote.bytes()));
    CHECK(parse(long_header).notes.size() == 1);
    CHECK(parse(long_header).warnings.empty());

    Bytes riff = {'R', 'I', 'F', 'F', 0, 0, 0, 0, 'R', 'M', 'I', 'D', 'i', 'n',
                  'f', 'o', 3,   0,   0, 0, 1, 2, 3,   0,   'd', 'a', 't', 'a'};
    test::append(riff, {static_cast<std::uint8_t>(plain.size()), 0, 0, 0});
    test::append(riff, plain);
    test::append(riff, {'t', 'a', 'i', 'l', 0, 0, 0, 0});
    CHECK(parse(riff).notes.size() == 1);
    CHECK(parse(riff).warnings.empty());
}

TEST_CASE("a track that is cut is read as far as it goes, at every byte") {
    const Bytes whole = test::midi_file(0, 96, {Track().note(0, 36).note(9, 38).note(9, 42).end()});
    std::size_t before = 0;
    for (std::size_t size = 22; size < whole.size(); ++size) {
        const MidiFile file = parse({whole.begin(), whole.begin() + size});
        CHECK(file.notes.size() >= before);
        CHECK(warns(file, "byte 18: track 1 says"));
        before = file.notes.size();
    }
    CHECK(before == 3);
}

TEST_CASE("lengths and counts that are wrong are warned of, and the tracks found all the same") {
    Bytes bytes = test::midi_file(1, 96, {kOneNote, kOneNote, kOneNote});
    const std::size_t track = 8 + kOneNote.bytes().size();
    SUBCASE("a track too long") {
        bytes[14 + 7] += 3;
        CHECK(warns(parse(bytes), "byte 18: the length of track 1 says"));
    }
    SUBCASE("a track too short") {
        bytes[14 + 7] -= 4;
        CHECK(warns(parse(bytes), "skipped 4 bytes"));
    }
    SUBCASE("a count of tracks") {
        bytes[11] = 7;
        CHECK(warns(parse(bytes), "byte 10: the header says 7 tracks and there are 3"));
    }
    SUBCASE("rubbish between two tracks") {
        bytes.insert(bytes.begin() + 14 + track, {1, 2, 3, 4, 5});
        CHECK(warns(parse(bytes), "skipped 5 bytes"));
    }
    SUBCASE("a length that no file has") {
        bytes[14 + 2 * track + 4] = 0xFF;
        CHECK(warns(parse(bytes), "track 3 says"));
    }
    CHECK(parse(bytes).notes.size() == 3);
}

TEST_CASE("a file that is wrong in a thousand places is not complained of a thousand times") {
    const std::vector<Track> bad(1000, Track().raw(0, {0xF4}));
    const MidiFile file = parse(test::midi_file(1, 96, bad));
    CHECK(file.tracks == 1000);
    CHECK(file.warnings.size() == 32);
}

TEST_CASE("an empty track is a track") {
    const MidiFile file = parse(test::midi_file(1, 96, {Track(), kOneNote}));
    CHECK(file.tracks == 2);
    CHECK(file.notes.size() == 1);
    CHECK(file.warnings.empty());
}

TEST_CASE("what is wrong inside a track is named, and what stands before it is kept") {
    const auto of = [](const Track& track) { return parse(test::midi_file(0, 96, {track})); };
    CHECK(warns(of(Track().raw(0, {0x40, 0x40})), "byte 23: expected a status byte, found 40"));
    CHECK(warns(of(Track().raw(0, {0x99, 0x80})), "byte 24: expected a data byte, found 80"));
    CHECK(warns(of(Track().raw(0, {0xF4})), "byte 23: expected an event, found F4"));
    CHECK(warns(of(Track().tempo(0, 0).end()), "byte 23: expected a tempo above 0"));
    CHECK(warns(of(Track().metre(0, 0, 2).end()), "byte 23: expected a time signature"));
    CHECK(warns(of(Track().note(0, 38)), "byte 26: track 1 has no end-of-track event"));
    const MidiFile file = of(Track().note(0, 38).raw(0, {0xFF, 0x01, 0x81, 0x80, 0x80, 0x80, 0}));
    CHECK(file.notes.size() == 1);
    CHECK(warns(file, "expected a quantity of at most four bytes"));
}

TEST_CASE("what cannot be read gives the file, the byte and what was expected there") {
    const Bytes good = test::midi_file(0, 96, {kOneNote});
    const auto with = [&](std::size_t at, std::uint8_t value) {
        Bytes bytes = good;
        bytes[at] = value;
        return error_of(bytes);
    };
    CHECK(error_of(good) == "read");
    CHECK(with(2, '0') == "song.mid: byte 0: expected a header chunk 'MThd', found 'MT0d'");
    CHECK(with(15, 'X') == "song.mid: byte 14: expected a track chunk 'MTrk', found 'MXrk'");
    CHECK(with(9, 3) == "song.mid: byte 8: expected format 0, 1 or 2, found 3");
    CHECK(with(13, 0) == "song.mid: byte 12: expected ticks in a quarter note, found 0");
    CHECK(with(12, 0xF0) ==
          "song.mid: byte 12: expected SMPTE time of 24, 25, 29 or 30 frames a second, found 16");
    CHECK(with(7, 5) == "song.mid: byte 4: expected a header of at least 6 bytes, found 5");
    CHECK(error_of({}) ==
          "song.mid: byte 0: expected a header chunk 'MThd', found the end of the file");
    CHECK(error_of({good.begin(), good.begin() + 9}) ==
          "song.mid: byte 8: expected 2 more bytes, found 1");
    CHECK(error_of({good.begin(), good.begin() + 14}) ==
          "song.mid: byte 14: expected a track chunk 'MTrk', found the end of the file");
    CHECK_THROWS_WITH_AS(read_midi_file("/no/such.mid"), "/no/such.mid: cannot be opened",
                         MidiError);
    CHECK_THROWS_AS(read_midi_file("/"), MidiError);
}
