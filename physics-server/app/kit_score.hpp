// A score for a whole kit: read, planned, with what was left out in words.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/score/kit_plan.hpp"

namespace percussionist::app {

struct KitScore {
    std::string title;
    std::size_t notes = 0;
    std::vector<score::KitStroke> strokes;  ///< in order of time
    std::vector<std::string> remarks;       ///< warnings of the reader, each note left out
};

/// As score_loader.hpp reads it; the kit's reach is noted. Throws as that, and as plan_kit().
KitScore load_kit_score(const std::filesystem::path& path, const score::Kit& kit);

/// A kit's file, or the standard kit if `path` is empty; and its text. Throws files::KitError.
score::Kit load_kit(const std::filesystem::path& path);
std::string kit_text(const std::filesystem::path& path);

/// A kit's text with its scripts and poses as `kit` has them: those of its own lines that say
/// others are left out, theirs are added.
std::string kit_text_with(const std::string& text, const score::Kit& kit);

}  // namespace percussionist::app
