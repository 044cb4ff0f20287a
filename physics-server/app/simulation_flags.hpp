// The flags that every command with a simulation has.
#pragma once

#include <CLI/App.hpp>

#include "sim/simulation.hpp"

namespace percussionist::app {

/// Adds --rate, --law and the like; `options` is theirs to fill and has to outlive the parsing.
void add_simulation_flags(CLI::App& command, sim::SimulationOptions& options);

}  // namespace percussionist::app
