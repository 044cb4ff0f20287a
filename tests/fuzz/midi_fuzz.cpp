// Any bytes: a MIDI file is read and its strokes are planned, for one drum and for a kit, or one
// MidiError comes.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "core/score/kit_plan.hpp"
#include "core/score/stroke_plan.hpp"
#include "files/midi_file.hpp"
#include "support/small_kit.hpp"

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
        static const score::Kit kit = test::small_kit();
        const score::KitPlan on_kit = score::plan_kit(score, kit);
        if (on_kit.strokes.size() + on_kit.left_out.size() + on_kit.doubles.size() !=
            score.notes.size()) {
            std::abort();
        }
    } catch (const files::MidiError&) {
    }
    return 0;
}
