#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/opening_messages.hpp"
#include "app/performance_files.hpp"
#include "app/simulation_flags.hpp"

namespace percussionist::app {

namespace {

struct RenderOptions {
    std::filesystem::path score;
    std::filesystem::path folder;
    std::vector<std::string> messages;
    FileOptions files;
    sim::SimulationOptions simulation;
};

void render(const RenderOptions& options) {
    LoadedScore score = load_score(options.score, options.simulation.person);
    for (const std::string& remark : score.remarks) fmt::print(stderr, "{}\n", remark);
    fmt::print("score: {}: {} of {} notes as strokes\n", score.title, score.strokes.size(),
               score.notes);

    Performance performance(options.simulation);
    Steering steering(performance, body::built_in_gestures());
    performance.load(std::move(score.strokes), score.motion);
    obey(steering, options.messages);
    PerformanceFiles files(options.folder, options.files, performance);
    performance.play();
    while (performance.playing()) {
        performance.step();
        files.stepped();
    }
    const double peak = files.finish();
    fmt::print("{}peak level         {:.3f}\n", describe(performance.summary()), peak);
}

}  // namespace

void add_render_command(CLI::App& program) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *program.add_subcommand(
        "render",
        "play a score as fast as it can into files: contacts.csv, motion.bvh, motion.glb, "
        "performance.wav");
    command.add_option(
        "score", options->score,
        "a MIDI or MusicXML file, a recording, or captured motion (BVH, CSV of sticks); none: "
        "the built-in piece");
    command.add_option("-o,--output", options->folder, "folder for the files")->required();
    add_opening_flag(command, options->messages);
    add_file_flags(command, options->files);
    add_simulation_flags(command, options->simulation);
    command.callback([options] { render(*options); });
}

}  // namespace percussionist::app
