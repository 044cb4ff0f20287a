#include "app/score_loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "files/midi_file.hpp"

namespace percussionist::app {

LoadedScore load_score(const std::filesystem::path& path) {
    LoadedScore loaded;
    score::Score score;
    if (path.empty()) {
        score = score::built_in_score();
    } else {
        const files::MidiFile file = files::read_midi_file(path);
        loaded.remarks = file.warnings;
        score = files::midi_to_score(file);
    }
    score::StrokePlan plan = score::plan_strokes(score);
    for (const auto* list : {&plan.left_out, &plan.doubles}) {
        for (const score::LeftOut& note : *list) {
            loaded.remarks.push_back("left out: " + score::describe(note, score));
        }
    }
    loaded.title = score.title.empty() ? path.filename().string() : score.title;
    loaded.notes = score.notes.size();
    loaded.strokes = std::move(plan.strokes);
    return loaded;
}

std::filesystem::path score_in_folder(const std::filesystem::path& folder,
                                      const std::string& name) {
    namespace fs = std::filesystem;
    if (name.empty() || name == "built-in") return {};
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) throw std::runtime_error(folder.string() + ": no such folder");
    const fs::path file = fs::canonical(root / name, error);
    if (error) throw std::runtime_error(name + ": no such file in the score folder");
    const auto [end, unused] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) {
        throw std::runtime_error(name + ": lies outside the score folder");
    }
    return file;
}

}  // namespace percussionist::app
