#include "app/kit_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app/score_loader.hpp"
#include "files/kit_file.hpp"
#include "files/text_lines.hpp"

namespace percussionist::app {

KitScore load_kit_score(const std::filesystem::path& path, const score::Kit& kit) {
    KitScore loaded;
    const score::Score score = read_score(path, loaded.remarks);
    score::KitPlan plan = score::plan_kit(score, kit);
    for (const auto& note : plan.left_out) {
        loaded.remarks.push_back("left out: " + describe(note, score));
    }
    loaded.title = score.title.empty() ? path.filename().string() : score.title;
    loaded.notes = score.notes.size();
    loaded.strokes = std::move(plan.strokes);
    return loaded;
}

score::Kit load_kit(const std::filesystem::path& path) {
    return path.empty() ? files::standard_kit() : files::read_kit_file(path);
}

std::string kit_text(const std::filesystem::path& path) {
    constexpr std::uintmax_t kLargest = 1'000'000;
    return path.empty() ? std::string(files::standard_kit_text())
                        : files::read_text<std::runtime_error>(path, kLargest);
}

std::string kit_text_with(const std::string& text, const score::Kit& kit) {
    std::string all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first;
        if (first != "pose" && first != "script") all += line + '\n';
    }
    return all + files::script_lines(kit) + files::pose_lines(kit, kit.poses);
}

}  // namespace percussionist::app
