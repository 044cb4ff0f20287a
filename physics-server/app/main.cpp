// percussionist: the physics server and its tools. percussionist --help explains itself.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/commands.hpp"

int main(int argc, char** argv) {
    using namespace percussionist::app;
    CLI::App program{
        "A simulated percussionist: a body in a physics engine that plays a score on a "
        "drum and tells every contact over OSC."};
    program.name("percussionist");
    program.require_subcommand(1);
    program.set_version_flag("--version", PERCUSSIONIST_VERSION);
    try {
        add_serve_command(program);
        add_describe_command(program);
        add_render_command(program);
        add_plan_command(program);
        add_replay_command(program);
        add_film_command(program);
        add_figure_command(program);
        add_animate_command(program);
        add_check_command(program);
        add_samples_command(program);
        add_fastrak_sim_command(program);
        add_track_command(program);
        add_gestures_command(program);
        add_limits_command(program);
        add_convert_command(program);
        add_bench_command(program);
        add_modes_command(program);
        add_drum_command(program);
        add_transcribe_command(program);
        add_learn_drums_command(program);
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "percussionist: {}\n", error.what());
        return 1;
    }
    return 0;
}
