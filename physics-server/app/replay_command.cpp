#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.hpp"
#include "app/performance_files.hpp"
#include "app/real_time.hpp"
#include "app/server.hpp"
#include "app/simulation_flags.hpp"
#include "app/stop_signals.hpp"
#include "app/told_comparison.hpp"

namespace percussionist::app {

namespace {

/// As fast as it can: time is where one sleeps until.
class HurriedClock : public WallClock {
  public:
    [[nodiscard]] double now() const override { return now_; }
    void sleep_until(double time) override { now_ = time; }

  private:
    std::atomic<double> now_{1.0};
};

struct ReplayOptions {
    std::filesystem::path recording, folder;
    bool serve = false;
    FileOptions files;
    ServeOptions server;
};

void replay(ReplayOptions& options) {
    const auto take =
        std::make_shared<const files::Recording>(files::read_recording(options.recording));
    const std::string name = options.recording.filename().string();
    if (take->cut) fmt::print(stderr, "{}: cut; played as far as it goes\n", name);
    ServeOptions& server_options = options.server;
    const auto& settings = take->records.front().bytes;
    server_options.settings = {settings.begin(), settings.end()};
    server_options.simulation = simulation_of(server_options.settings, name);
    server_options.replay = take;
    ToldComparison comparison(*take);
    server_options.told = [&](std::int64_t step, const osc::Packet& packet) {
        comparison.told(step, packet);
    };
    if (!options.serve) server_options.endpoint.port = 0;
    std::unique_ptr<PerformanceFiles> written;
    server_options.stepped = [&](const Performance& performance) {
        if (options.folder.empty()) return;
        if (!written) {
            written =
                std::make_unique<PerformanceFiles>(options.folder, options.files, performance);
        }
        written->stepped();
    };
    const std::atomic<bool>& stop = stop_on_signals();
    const auto clock = options.serve ? std::unique_ptr<WallClock>(new SystemClock)
                                     : std::unique_ptr<WallClock>(new HurriedClock);
    Server server(server_options, *clock);
    if (options.serve) {
        fmt::print("listening on {} port {}\n", server_options.endpoint.listen, server.port());
        std::fflush(stdout);
        ask_for_real_time();
    }
    server.run(stop);
    if (written) written->finish();
    fmt::print("{}{}", describe(server.performance().summary()), comparison.describe());
    if (!stop && !comparison.same()) {
        throw std::runtime_error(name + ": played otherwise than recorded");
    }
}

}  // namespace

void add_replay_command(CLI::App& program) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App& command = *program.add_subcommand(
        "replay",
        "play a recording again, of serve --record or /record, and compare what comes of it to the "
        "last bit");
    command.add_option("recording", options->recording, "a .recording")->required();
    command.add_option("-o,--output", options->folder, "folder for the files that render writes");
    add_file_flags(command, options->files);
    command.add_option("--gestures", options->server.gestures,
                       "file of gestures of your own, if the recorded server had one");
    auto* serve =
        command.add_flag("--serve", options->serve, "in real time, over OSC as serve does");
    command
        .add_option("--listen", options->server.endpoint.listen,
                    "address to listen on, with --serve")
        ->needs(serve)
        ->capture_default_str();
    command.add_option("--port", options->server.endpoint.port, "UDP port, with --serve")
        ->needs(serve)
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command.callback([options] { replay(*options); });
}

}  // namespace percussionist::app
