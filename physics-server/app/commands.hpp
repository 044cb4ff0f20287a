// The subcommands of the program. Each adds itself to it: its flags, their help, and what it does.
//
// A command that fails throws std::exception with one clear line; main prints it and exits with 1.
#pragma once

#include <CLI/App.hpp>

namespace percussionist::app {

/// serve: the simulation in real time, told and telling over OSC.
void add_serve_command(CLI::App& program);
/// render: the same as fast as it can, into files.
void add_render_command(CLI::App& program);
/// check: how well a recording agrees with the contacts of its performance.
void add_check_command(CLI::App& program);
/// track: how well the body follows a captured motion.
void add_track_command(CLI::App& program);
/// gestures: the gestures that the body knows; more of them out of recordings.
void add_gestures_command(CLI::App& program);
/// limits: joint limits out of a captured motion.
void add_limits_command(CLI::App& program);
/// bench: how fast the simulation is.
void add_bench_command(CLI::App& program);

}  // namespace percussionist::app
