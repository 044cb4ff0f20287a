#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.hpp"
#include "app/gesture_library.hpp"
#include "app/gesture_score.hpp"
#include "app/opening_messages.hpp"
#include "app/simulation_flags.hpp"

namespace percussionist::app {

namespace {

struct PlanCommand {
    std::filesystem::path score, plot, gestures;
    double seconds = 10.0;
    std::vector<std::string> messages;
    sim::SimulationOptions simulation;
};

void print(const GestureOfStroke& g) {
    fmt::print("bar {} beat {:.2f}: {} {} at {:.2f} m/s: ", g.stroke.position.bar,
               g.stroke.position.beat, g.asked.hand == body::Hand::left ? "left" : "right",
               g.gesture, g.asked.shape.impact);
    if (!g.struck) {
        fmt::print("does not reach the head");
    } else {
        fmt::print(
            "{:.1f} ms off, tip at {:.1f} m/s, a joint at its torque limit {:.0f} % of the time",
            1e3 * g.contact_error, g.fastest, 100.0 * g.strained);
    }
    fmt::print("\n");
}

void plan(const PlanCommand& command) {
    LoadedScore loaded = load_score(command.score);
    for (const std::string& remark : loaded.remarks) fmt::print(stderr, "{}\n", remark);
    Performance performance(command.simulation);
    Steering steering(performance, load_gestures(command.gestures));
    performance.load(std::move(loaded.strokes));
    obey(steering, command.messages);
    const PlayedScore played = play_through(performance);
    int unplayable = 0;
    for (const GestureOfStroke& g : played.strokes) {
        if (g.playable()) continue;
        if (unplayable++ == 0) fmt::print("not playable as asked for:\n");
        print(g);
    }
    fmt::print("{}: {} strokes, {} of them playable; {} dropped for want of time\n", loaded.title,
               played.strokes.size(), static_cast<int>(played.strokes.size()) - unplayable,
               performance.player().dropped());
    if (command.plot.empty()) return;
    write_gesture_score(played, loaded.title, command.seconds, command.plot);
    fmt::print("{}: score-01.svg and on, strokes.csv, heights.csv\n", command.plot.string());
}

}  // namespace

void add_plan_command(CLI::App& program) {
    auto options = std::make_shared<PlanCommand>();
    CLI::App& command = *program.add_subcommand(
        "plan",
        "a score as gestures: how each stroke is prepared and played, and whether the body can; "
        "drawn as the score over the heights of both tips");
    command.add_option("score", options->score,
                       "a MIDI or MusicXML file; none: the built-in piece");
    command.add_option("--plot", options->plot, "folder for pictures and tables");
    command.add_option("--seconds", options->seconds, "of the score in one picture")
        ->check(CLI::Range(1.0, 120.0))
        ->capture_default_str();
    command.add_option("--gestures", options->gestures, "file of gestures of your own");
    add_opening_flag(command, options->messages);
    add_simulation_flags(command, options->simulation);
    command.callback([options] { plan(*options); });
}

}  // namespace percussionist::app
