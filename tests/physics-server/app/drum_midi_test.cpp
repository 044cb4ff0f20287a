#include "app/drum_midi.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "files/midi_writer.hpp"
#include "files/spectrogram_picture.hpp"

using namespace percussionist;
using listening::Beats;
using listening::DrumClass;

namespace {

listening::Transcription strokes() {
    listening::Transcription made;
    for (int n = 0; n < 40; ++n) {
        made.strokes.push_back({.time = 0.137 + 0.251 * n,
                                .drum = static_cast<DrumClass>(n % 8),
                                .velocity = 0.5,
                                .confidence = 0.8,
                                .pitch = 100.0});
    }
    return made;
}

Beats wandering_beats(double first) {
    Beats beats;
    double t = first;
    for (int b = 0; b < 20; ++b) {
        beats.times.push_back(t);
        t += 0.5 + 0.02 * std::sin(b);
    }
    beats.first_downbeat = 2;
    return beats;
}

}  // namespace

TEST_CASE("strokes keep their times through MIDI, wherever the beats are") {
    for (const double first : {0.0, 0.05, 0.4, 1.3}) {
        const auto made = strokes();
        const auto midi = app::to_midi(made, wandering_beats(first), "song");
        const auto score = files::midi_to_score(files::parse_midi(files::midi_bytes(midi), "song"));
        REQUIRE(score.notes.size() == made.strokes.size());
        for (std::size_t n = 0; n < score.notes.size(); ++n) {
            CHECK(score.notes[n].time ==
                  doctest::Approx(made.strokes[n].time).epsilon(1e-9).scale(1.0).epsilon(0.001));
            CHECK(score.notes[n].channel == 9);
        }
    }
}

TEST_CASE("a bar begins at the beat that was found to begin one") {
    const Beats beats = wandering_beats(0.4);
    const auto midi = app::to_midi(strokes(), beats, "song");
    const score::TempoMap map(midi.division, midi.tempos, midi.metres);
    const auto position = map.position_at(beats.times[2] + 1e-6);
    CHECK(position.beat == doctest::Approx(1.0).epsilon(0.01));
}

TEST_CASE("without beats there is MIDI all the same, and every class has its key") {
    const auto midi = app::to_midi(strokes(), {}, "song");
    CHECK(midi.notes.size() == 40);
    const auto again = files::parse_midi(files::midi_bytes(midi), "song");
    const int keys[] = {36, 38, 42, 46, 45, 49, 51, 37};
    for (std::size_t n = 0; n < 8; ++n) CHECK(again.notes[n].key == keys[n]);
}

TEST_CASE("the picture shows every stroke, and titles cannot break it") {
    auto made = strokes();
    made.heard.frames.resize(2100);
    const std::string svg = files::spectrogram_svg(made, wandering_beats(0.4), "rock <&> roll");
    std::size_t discs = 0;
    for (std::size_t at = svg.find("<circle"); at != std::string::npos;
         at = svg.find("<circle", at + 1))
        ++discs;
    CHECK(discs == 40);
    CHECK(svg.find("rock &lt;&amp;> roll") != std::string::npos);
    CHECK(svg.ends_with("</svg>\n"));
}
