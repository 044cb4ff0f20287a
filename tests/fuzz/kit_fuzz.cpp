// Any bytes as a kit file: a kit that can be played on, or one KitError. What it reads plays a
// short score without losing a note.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/score/kit_plan.hpp"
#include "files/kit_file.hpp"

namespace percussionist::files {
// The kit that comes with the program is made by CMake; no fuzzer needs it.
std::string_view standard_kit_text() {
    return {};
}
}  // namespace percussionist::files

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace percussionist;
    try {
        const score::Kit kit = files::parse_kit(
            std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.kit");
        score::Score song;
        for (int i = 0; i < 60; ++i) {
            song.notes.push_back({0.06 * (i / 2), 35 + i % 47, 0.5, 9, {}});
        }
        const score::KitPlan plan = score::plan_kit(song, kit);
        if (plan.strokes.size() + plan.left_out.size() + plan.doubles.size() != song.notes.size()) {
            std::abort();
        }
        if (audit(plan, kit).crossed != 0) std::abort();
    } catch (const files::KitError&) {
    }
    return 0;
}
