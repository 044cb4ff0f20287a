// Any bytes: MusicXML is read as notes in order of time, whose strokes can be planned, or one
// MusicXmlError comes. What is long is not planned here: it takes the time that reading should
// have, and the fuzzer of MIDI plans it.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/score/stroke_plan.hpp"
#include "files/musicxml_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const score::Score score =
            files::parse_musicxml({reinterpret_cast<const char*>(data), size}, "fuzz.musicxml");
        double last = 0.0;
        for (const score::Note& note : score.notes) {
            if (!(note.time >= last && std::isfinite(note.time))) std::abort();
            if (!(note.velocity > 0.0 && note.velocity <= 1.0)) std::abort();
            last = note.time;
        }
        constexpr std::size_t kShort = 12;
        if (score.notes.size() <= kShort) score::plan_strokes(score);
    } catch (const files::MusicXmlError&) {
    }
    return 0;
}
