// The flags that every command with a simulation has.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "sim/simulation.hpp"

namespace percussionist::app {

/// Adds --rate, --law and the like; `options` is theirs to fill and has to outlive the parsing.
void add_simulation_flags(CLI::App& command, sim::SimulationOptions& options);

/// Those that were given to a command that has them, one a line: what a recording needs to make the
/// same simulation again.
std::string simulation_settings(const CLI::App& command);
/// Throws std::runtime_error naming `name` where they cannot be understood.
sim::SimulationOptions simulation_of(const std::string& settings, const std::string& name);

}  // namespace percussionist::app
