#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "core/score/stroke_plan.hpp"
#include "files/midi_file.hpp"
#include "support/plan_laws.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

TEST_CASE("real files are read without a warning, and no note of theirs is lost unsaid") {
    for (const auto& path : test::real_files("midi", ".mid")) {
        CAPTURE(path.string());
        const files::MidiFile file = files::read_midi_file(path);
        const score::Score score = files::midi_to_score(file);
        CHECK(file.warnings.empty());
        CHECK(score.notes.size() > 200);
        CHECK(score.duration > 10.0);
        const score::StrokePlan plan = score::plan_strokes(score);
        test::check_no_note_is_lost(score, plan);
        test::check_hands_can_play(score, plan, score::PlanOptions{}.min_interval);
        CHECK(plan.strokes.size() > score.notes.size() / 2);
    }
}

TEST_CASE("valid odd files are read, damaged ones say what is wrong with them") {
    // What each of these files says; the rest say nothing. (MIDIBadFormat1 is sound.)
    const std::pair<const char*, const char*> says[] = {
        {"MIDIBadHeaderChunk", "byte 0: expected a header chunk 'MThd', found 'MT0d'"},
        {"MIDIBadHeaderFormat", "byte 8: expected format 0, 1 or 2, found 3"},
        {"MIDIBadHeaderLength", "byte 4: the header says that it has 22 bytes, and it has 6"},
        {"MIDIBadHeaderSMTPE", "byte 12: expected SMPTE time of 24, 25, 29 or 30 frames"},
        {"MIDIBadHeaderTracksNum", "byte 10: the header says 2 tracks and there are 1"},
        {"MIDIBadTrackHdr", "byte 14: expected a track chunk 'MTrk', found 'mTrk'"},
        {"MIDIBadTrackLength", "byte 18: track 1 says 16777275 bytes and 59 are there"},
        {"MIDIOkFormat2", "format 2: 9 independent sequences"},
        {"truncated_in_track", "byte 18: track 1 says 4771 bytes and 3173 are there"}};
    for (const auto& path : test::real_files("midi/damaged", ".mid")) {
        const std::string name = path.stem().string();
        CAPTURE(name);
        std::string said;
        bool read = true;
        try {
            const files::MidiFile file = files::read_midi_file(path);
            for (const std::string& warning : file.warnings) {
                if (warning.find("no percussion channel") == std::string::npos) {
                    said += warning + "\n";
                }
            }
            CHECK(files::midi_to_score(file).notes.size() >= 4);
        } catch (const files::MidiError& error) {
            said = error.what();
            read = false;
        }
        CHECK((read || name.find("Ok") == std::string::npos));
        const auto* expected = std::find_if(std::begin(says), std::end(says),
                                            [&](const auto& entry) { return entry.first == name; });
        if (expected == std::end(says)) {
            CHECK(said.empty());
        } else {
            CHECK(said.find(expected->second) != std::string::npos);
        }
    }
}
