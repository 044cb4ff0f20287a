// Reads MIDI files, plans them on a kit and tells what became of the notes, a table row a file:
//     kit_report [--kit FILE] [--each] [--strokes] [--hour] FILE...
// --each: every note that is left out; --strokes: who plays what, and why; --hour: also the file
// repeated until it lasts an hour, to see how long planning takes.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "core/score/kit_plan.hpp"
#include "files/kit_file.hpp"
#include "files/midi_file.hpp"

using namespace percussionist;

namespace {

struct Wishes {
    score::Kit kit = files::standard_kit();
    bool each = false, strokes = false, hour = false;
};

score::Score hour_of(const score::Score& score) {
    score::Score hour = score;
    const double length = std::max(score.duration, 1.0);
    for (double start = length; start < 3600.0; start += length) {
        for (score::Note note : score.notes) {
            note.time += start;
            hour.notes.push_back(note);
        }
    }
    return hour;
}

void row(const std::string& name, const score::Score& score, const Wishes& wishes) {
    const auto start = std::chrono::steady_clock::now();
    const score::KitPlan plan = score::plan_kit(score, wishes.kit);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    const score::KitAudit audit = score::audit(plan, wishes.kit);
    std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %.1f |\n", name.c_str(),
                score.notes.size(), plan.strokes.size(), plan.left_out.size(), plan.doubles.size(),
                audit.hits, audit.crossed, audit.too_fast, audit.too_often, took.count());
    for (std::size_t i = 0; wishes.each && i < plan.left_out.size(); ++i) {
        std::printf("%s\n", describe(plan.left_out[i], score).c_str());
    }
    for (std::size_t i = 0; wishes.strokes && i < plan.strokes.size(); ++i) {
        const score::KitStroke& s = plan.strokes[i];
        const score::Position& at = score.notes[s.note].position;
        std::printf("%4d %5.2f %8.3f %-11s %-12s %3.0f %s%s\n", at.bar, at.beat, s.time,
                    std::string(score::name(s.limb)).c_str(),
                    wishes.kit.events[s.event].name.c_str(), 127 * s.velocity,
                    std::string(score::kReasonNames[static_cast<std::size_t>(s.reason)]).c_str(),
                    s.bounces ? ", bounced" : "");
    }
}

void report(const std::string& path, const Wishes& wishes) {
    const files::MidiFile file = files::read_midi_file(path);
    const score::Score score = files::midi_to_score(file);
    row(file.name, score, wishes);
    if (wishes.hour) row(file.name + ", an hour", hour_of(score), wishes);
}

}  // namespace

int main(int argc, char** argv) {
    Wishes wishes;
    std::puts(
        "| file | notes | strokes | left out | doubles | of hands | crossed | too fast | too often "
        "| ms |\n|---|---|---|---|---|---|---|---|---|---|");
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        try {
            if (word == "--kit" && i + 1 < argc) {
                wishes.kit = files::read_kit_file(argv[++i]);
            } else if (word == "--each") {
                wishes.each = true;
            } else if (word == "--strokes") {
                wishes.strokes = true;
            } else if (word == "--hour") {
                wishes.hour = true;
            } else {
                report(word, wishes);
            }
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
        }
    }
}
