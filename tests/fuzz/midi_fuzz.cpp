// Any bytes: a MIDI file is read and its strokes are planned, or one MidiError comes.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/score/stroke_plan.hpp"
#include "files/midi_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const auto file = files::parse_midi(std::span(data, size), "fuzz.mid");
        const score::Score score = files::midi_to_score(file);
        const score::StrokePlan plan = score::plan_strokes(score);
        if (plan.strokes.size() + plan.left_out.size() + plan.doubles.size() !=
            score.notes.size()) {
            std::abort();
        }
    } catch (const files::MidiError&) {
    }
    return 0;
}
