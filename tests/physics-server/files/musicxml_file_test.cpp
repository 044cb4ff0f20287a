#include "files/musicxml_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

using namespace percussionist;
using score::Nuance;

namespace {

/// A document of one part with these measures, two divisions a quarter.
std::string document(const std::string& measures) {
    return R"(<?xml version="1.0"?><score-partwise version="4.0"><part-list><score-part id="P1">
<score-instrument id="I1"><instrument-name>Timpani</instrument-name></score-instrument>
<midi-instrument id="I1"><midi-unpitched>48</midi-unpitched></midi-instrument>
</score-part></part-list><part id="P1">)" +
           measures + "</part></score-partwise>";
}

std::string measure(const std::string& content) {
    return "<measure><attributes><divisions>2</divisions></attributes>" + content + "</measure>";
}

std::string note(const std::string& content, int duration = 2) {
    return "<note><unpitched/><duration>" + std::to_string(duration) + "</duration>" + content +
           "</note>";
}

std::string articulated(const std::string& mark) {
    return "<notations><articulations><" + mark + "/></articulations></notations>";
}

score::Score read(const std::string& text) {
    return files::parse_musicxml(text, "test.musicxml");
}

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const files::MusicXmlError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("musicxml: notes stand where durations, chords, backup and rests put them") {
    const auto s = read(document(measure(
        note("") + "<note><rest/><duration>2</duration></note>" + note("") + note("<chord/>") +
        "<backup><duration>6</duration></backup>" + note("", 1) + note("", 1))));
    REQUIRE(s.notes.size() == 5);
    const double expected[] = {0.0, 0.0, 0.25, 1.0, 1.0};
    for (std::size_t i = 0; i < 5; ++i) CHECK(s.notes[i].time == doctest::Approx(expected[i]));
    CHECK(s.notes[0].instrument == 47);
}

TEST_CASE("musicxml: articulations are nuances") {
    const auto s = read(document(
        measure(note("") + note(articulated("accent")) + note(articulated("strong-accent")) +
                note(articulated("staccato")) + note(articulated("tenuto")))));
    REQUIRE(s.notes.size() == 5);
    CHECK(s.notes[0].nuance == Nuance::legato);
    CHECK(s.notes[1].nuance == Nuance::accent);
    CHECK(s.notes[2].nuance == Nuance::vertical_accent);
    CHECK(s.notes[3].nuance == Nuance::staccato);
    CHECK(s.notes[4].nuance == Nuance::tenuto);
    for (const auto& n : s.notes) CHECK(n.velocity == s.notes[0].velocity);  // the dynamic's
}

TEST_CASE("musicxml: tempo marks and a ritardando between them") {
    const auto mark = [](int bpm) {
        return "<direction><sound tempo=\"" + std::to_string(bpm) + "\"/></direction>";
    };
    const std::string four = note("") + note("") + note("") + note("");
    const auto steady = read(document(measure(mark(60) + four)));
    CHECK(steady.notes[3].time == doctest::Approx(3.0));
    const auto slower = read(document(
        measure(mark(120) +
                "<direction><direction-type><words>rit.</words></direction-type></direction>" +
                four) +
        measure(mark(60) + four)));
    double last = 0.0;
    for (int i = 1; i < 5; ++i) {
        const double gap = slower.notes[i].time - slower.notes[i - 1].time;
        CHECK(gap > last);
        CHECK(gap < 1.0);
        last = gap;
    }
    CHECK(slower.notes[6].time - slower.notes[5].time == doctest::Approx(1.0));
}

TEST_CASE("musicxml: dynamics hold until the next, a hairpin leads from one to the other") {
    const auto mark = [](const std::string& dynamic) {
        return "<direction><direction-type><dynamics><" + dynamic +
               "/></dynamics></direction-type></direction>";
    };
    const auto wedge = [](const std::string& type) {
        return "<direction><direction-type><wedge type=\"" + type +
               "\"/></direction-type></direction>";
    };
    const auto s =
        read(document(measure(mark("p") + note("") + wedge("crescendo") + note("") + note("") +
                              note("") + wedge("stop") + mark("f") + note(""))));
    REQUIRE(s.notes.size() == 5);
    CHECK(s.notes[0].velocity == doctest::Approx(0.39));
    CHECK(s.notes[4].velocity == doctest::Approx(0.76));
    for (int i = 2; i < 5; ++i) CHECK(s.notes[i].velocity > s.notes[i - 1].velocity);
}

TEST_CASE("musicxml: a tremolo is the strokes it stands for") {
    const auto s = read(document(measure(note(
        "<notations><ornaments><tremolo type=\"single\">3</tremolo></ornaments></notations>", 4))));
    REQUIRE(s.notes.size() == 16);  // two quarters of thirty-seconds
    for (std::size_t i = 1; i < 16; ++i) {
        CHECK(s.notes[i].time - s.notes[i - 1].time == doctest::Approx(0.0625));
    }
}

TEST_CASE("musicxml: a grace note is a flam: just before its note, and softer") {
    const auto s =
        read(document(measure(note("") + "<note><grace/><unpitched/></note>" + note(""))));
    REQUIRE(s.notes.size() == 3);
    const double before = s.notes[2].time - s.notes[1].time;
    CHECK(before > 0.015);
    CHECK(before < 0.045);
    CHECK(s.notes[1].velocity < s.notes[2].velocity);
}

TEST_CASE("musicxml: repeats are played, endings in their turn") {
    const std::string back =
        "<barline location=\"right\"><ending number=\"1\" type=\"stop\"/>"
        "<repeat direction=\"backward\"/></barline>";
    const std::string first = "<barline><ending number=\"1\" type=\"start\"/></barline>";
    const std::string second = "<barline><ending number=\"2\" type=\"start\"/></barline>";
    const auto s = read(document(measure(note("")) + measure(first + note("") + note("") + back) +
                                 measure(second + note(""))));
    // 1, ending 1 (two notes), 1, ending 2.
    CHECK(s.notes.size() == 5);
}

TEST_CASE("musicxml: a tied note is struck once") {
    const auto s = read(
        document(measure(note("<tie type=\"start\"/>") + note("<tie type=\"stop\"/>") + note(""))));
    REQUIRE(s.notes.size() == 2);
    CHECK(s.notes[1].time == doctest::Approx(1.0));
}

TEST_CASE("musicxml: what is not MusicXML is refused by file and line") {
    CHECK(refusal("<a>\n<b>\n</a>").find("test.musicxml: line") != std::string::npos);
    CHECK(refusal("<html/>").find("score-partwise") != std::string::npos);
    CHECK(refusal("").find("test.musicxml") != std::string::npos);
    CHECK(refusal("PK\x03\x04").find("zip archive") != std::string::npos);
}

TEST_CASE("musicxml: whatever the bytes, reading ends in a score or an error") {
    const std::string good = document(measure(
        note(articulated("accent")) + note("<chord/>") + "<backup><duration>2</duration></backup>" +
        note("<notations><ornaments><tremolo>3</tremolo></ornaments></notations>")));
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        std::string text = good;
        for (int k = 0; k < 4; ++k)
            text[random() % text.size()] = "<>/0123456789ax\"-"[random() % 17];
        try {
            const auto s = read(text);
            for (const auto& n : s.notes) CHECK(std::isfinite(n.time));
        } catch (const files::MusicXmlError&) {
        }
    }
}
