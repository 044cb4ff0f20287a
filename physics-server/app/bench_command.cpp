#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "app/commands.hpp"
#include "app/performance.hpp"
#include "app/simulation_flags.hpp"

namespace percussionist::app {

namespace {

struct BenchOptions {
    double seconds = 10.0;
    sim::SimulationOptions simulation;
};

void bench(const BenchOptions& options) {
    Performance performance(options.simulation);
    performance.load(load_score({}).strokes);
    performance.play();
    const auto start = std::chrono::steady_clock::now();
    long steps = 0;
    while (performance.simulation().time() < options.seconds) {
        performance.step();
        if (!performance.playing()) performance.play();
        ++steps;
    }
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("{:.0f} Hz: {:.0f} steps a second, {:.1f} times real time, {:.1f} us a step\n",
               options.simulation.rate, static_cast<double>(steps) / spent, options.seconds / spent,
               1e6 * spent / static_cast<double>(steps));
}

}  // namespace

void add_bench_command(CLI::App& program) {
    auto options = std::make_shared<BenchOptions>();
    CLI::App& command = *program.add_subcommand(
        "bench", "how fast the simulation is on one core, playing the built-in piece");
    command.add_option("--seconds", options->seconds, "of simulated time")
        ->check(CLI::Range(0.1, 1e5))
        ->capture_default_str();
    add_simulation_flags(command, options->simulation);
    command.callback([options] { bench(*options); });
}

}  // namespace percussionist::app
