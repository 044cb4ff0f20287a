// `percussionist fastrak-sim`: a FASTRAK to try everything on, without hardware.
#pragma once

#include <CLI/CLI.hpp>

namespace percussionist::app {

/// Its callback runs until SIGINT, SIGTERM, "quit" on standard input or --duration; it throws
/// std::runtime_error, one line, on failure.
void add_fastrak_sim_command(CLI::App& program);

}  // namespace percussionist::app
