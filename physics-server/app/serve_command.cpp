#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands.hpp"
#include "app/kit_server.hpp"
#include "app/real_time.hpp"
#include "app/route_file.hpp"
#include "app/server.hpp"
#include "app/simulation_flags.hpp"
#include "app/stop_signals.hpp"
#include "osc/announcement.hpp"

namespace percussionist::app {

namespace {

template <class AnyServer, class Options>
void serve(const Options& options, const auto& summary) {
    const std::atomic<bool>& stop = stop_on_signals();
    SystemClock clock;
    AnyServer server(options, clock);
    fmt::print("listening on {} port {}\n", options.endpoint.listen, server.port());
    std::fflush(stdout);
    std::optional<osc::Announcement> announcement;
    if (options.endpoint.listen == "0.0.0.0") announcement.emplace(server.port());
    ask_for_real_time();
    server.run(stop);
    fmt::print("{}late steps         {}\n", describe(summary(server)), server.late_steps());
}

void serve_drum(const ServeOptions& options) {
    serve<Server>(options, [](const Server& s) { return s.performance().summary(); });
}

void serve_kit(const ServeOptions& options, const std::filesystem::path& kit, bool simulated) {
    if (!options.recording.empty()) throw std::runtime_error("--record: not with --kit");
    KitServeOptions all;
    all.endpoint = options.endpoint;
    all.kit = kit;
    all.simulated = simulated;
    all.score = options.score;
    all.score_folder = options.score_folder;
    all.play = options.play;
    all.quit_at_end = options.quit_at_end;
    all.log_folder = options.log_folder;
    try {
        serve<KitServer>(all, [](const KitServer& s) { return s.summary(); });
    } catch (const std::invalid_argument& error) {
        throw std::runtime_error(error.what());
    }
}

}  // namespace

void add_serve_command(CLI::App& program) {
    auto options = std::make_shared<ServeOptions>();
    auto routes = std::make_shared<std::filesystem::path>();
    CLI::App& command = *program.add_subcommand(
        "serve", "simulate in real time; hear and tell over OSC (docs/osc-protocol.md)");
    command.add_option(
        "score", options->score,
        "a MIDI or MusicXML file, a recording, or captured motion (BVH, CSV of sticks); none: "
        "the built-in piece");
    command
        .add_option("--listen", options->endpoint.listen,
                    "address to listen on; 0.0.0.0 for every network of this machine")
        ->capture_default_str();
    command.add_option("--port", options->endpoint.port, "UDP port to listen on; 0: any free one")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command
        .add_option("--lookahead", options->endpoint.lookahead,
                    "between a contact and its sound: time for the network [s]")
        ->check(CLI::Range(0.015, 2.0))
        ->capture_default_str();
    command.add_option("--allow", options->endpoint.allow,
                       "hosts that others may have events sent to, besides this one and their own");
    command.add_option("--routes", *routes, "file of routes from the start");
    command
        .add_option("--scores", options->score_folder,
                    "folder that /score may read from, /record and /route/save write to")
        ->default_str(".");
    command.add_option("--gestures", options->gestures,
                       "file of gestures of your own, as `percussionist gestures add` writes it");
    command.add_flag("--play", options->play, "play at once, without waiting for /play");
    command.add_flag("--quit-at-end", options->quit_at_end, "end when the score has rung out");
    command.add_option("--log", options->log_folder, "folder for contacts.csv, written at the end");
    command.add_option("--record", options->recording,
                       "file for what is told, heard and played, from the start (replay plays it)");
    auto kit = std::make_shared<std::string>();
    CLI::Option* with_kit =
        command
            .add_option("--kit", *kit,
                        "a drummer at a whole kit: a kit file; none: the standard kit")
            ->expected(0, 1);
    auto simulated = std::make_shared<bool>(false);
    command
        .add_flag("--simulated", *simulated,
                  "with --kit: his body plays, led by the key frames, and its contacts are heard")
        ->needs(with_kit);
    add_simulation_flags(command, options->simulation);
    command.callback([options, routes, kit, with_kit, simulated, &command] {
        options->settings = simulation_settings(command);
        if (!routes->empty()) options->endpoint.routes = read_routes(*routes);
        options->endpoint.before_sending = [] { ask_for_real_time(); };
        if (options->score_folder.empty()) options->score_folder = ".";
        if (with_kit->count() > 0) {
            serve_kit(*options, *kit, *simulated);
        } else {
            serve_drum(*options);
        }
    });
}

}  // namespace percussionist::app
