#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/bvh_writer.hpp"
#include "app/commands.hpp"
#include "app/drum_sound.hpp"
#include "app/opening_messages.hpp"
#include "app/performance.hpp"
#include "app/simulation_flags.hpp"

namespace percussionist::app {

namespace {

struct RenderOptions {
    std::filesystem::path score;
    std::filesystem::path folder;
    std::vector<std::string> messages;
    double frames = 120.0;  ///< a second, of the motion [Hz]
    int sample_rate = 48000;
    sim::SimulationOptions simulation;
};

void render(const RenderOptions& options) {
    LoadedScore score = load_score(options.score);
    for (const std::string& remark : score.remarks) fmt::print(stderr, "{}\n", remark);
    fmt::print("score: {}: {} of {} notes as strokes\n", score.title, score.strokes.size(),
               score.notes);

    std::filesystem::create_directories(options.folder);
    Performance performance(options.simulation);
    Steering steering(performance, body::built_in_gestures());
    BvhWriter motion(options.folder / "motion.bvh", performance.simulation().skeleton(),
                     1.0 / options.frames);
    performance.load(std::move(score.strokes));
    obey(steering, options.messages);
    performance.play();
    int frames = 0;
    while (performance.playing()) {
        performance.step();
        if (performance.simulation().time() * options.frames >= frames) {
            motion.add(performance.simulation().placement());
            ++frames;
        }
    }
    motion.finish();
    performance.log().write_csv(options.folder / "contacts.csv");
    const files::Audio sound = drum_sound(performance.log(), performance.simulation().time(),
                                          options.sample_rate, options.simulation.head);
    files::write_wav(options.folder / "performance.wav", sound);
    fmt::print("{}peak level         {:.3f}\n", describe(performance.summary()), peak(sound));
}

}  // namespace

void add_render_command(CLI::App& program) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *program.add_subcommand(
        "render",
        "play a score as fast as it can into files: contacts.csv, motion.bvh, performance.wav");
    command.add_option("score", options->score,
                       "a MIDI or MusicXML file; none: the built-in piece");
    command.add_option("-o,--output", options->folder, "folder for the files")->required();
    command.add_option("--frames", options->frames, "of the motion [Hz]")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    command.add_option("--sample-rate", options->sample_rate, "of the sound [Hz]")
        ->check(CLI::Range(8000, 192000))
        ->capture_default_str();
    add_opening_flag(command, options->messages);
    add_simulation_flags(command, options->simulation);
    command.callback([options] { render(*options); });
}

}  // namespace percussionist::app
