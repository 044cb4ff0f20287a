// Reads MIDI files, plans their strokes and tells what became of the notes, a table row a file:
//     score_report FILE...      with --each, every note that is left out, too
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "core/score/stroke_plan.hpp"
#include "files/midi_file.hpp"

using namespace percussionist;

namespace {

/// The median of several runs, each of reading the file and planning [ms].
double time_to_read(const std::string& path) {
    std::vector<double> times;
    for (int i = 0; i < 21; ++i) {
        const auto start = std::chrono::steady_clock::now();
        (void)files::midi_to_score(files::read_midi_file(path));
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    std::nth_element(times.begin(), times.begin() + 10, times.end());
    return times[10];
}

double time_to_plan(const score::Score& score) {
    const auto start = std::chrono::steady_clock::now();
    (void)score::plan_strokes(score);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void report(const std::string& path, bool each) {
    const files::MidiFile file = files::read_midi_file(path);
    const score::Score score = files::midi_to_score(file);
    const score::StrokePlan plan = score::plan_strokes(score);
    std::map<score::Why, std::size_t> why;
    for (const auto& left_out : plan.left_out) {
        ++why[left_out.why];
    }
    std::printf("| %s | %.1f | %zu | %zu | %zu | %zu | %zu | %.2f | %.2f |\n", file.name.c_str(),
                score.duration, score.notes.size(), plan.strokes.size(),
                why[score::Why::third_at_once], why[score::Why::too_fast], plan.doubles.size(),
                time_to_read(path), time_to_plan(score));
    for (const std::string& warning : file.warnings) {
        std::fprintf(stderr, "%s\n", warning.c_str());
    }
    for (std::size_t i = 0; each && i < plan.left_out.size(); ++i) {
        std::printf("%s\n", score::describe(plan.left_out[i], score).c_str());
    }
}

}  // namespace

int main(int argc, char** argv) {
    bool each = false;
    std::puts(
        "| file | length s | notes | strokes | a third at once | too fast | doubles | reading ms "
        "| planning ms |\n|---|---|---|---|---|---|---|---|---|");
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--each") {
            each = true;
            continue;
        }
        try {
            report(argv[i], each);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
        }
    }
}
