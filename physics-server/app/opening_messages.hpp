// How a performance begins that is made as fast as it can be: the same messages that a running
// server takes over OSC, as lines of text ("/nuance accent left", "/tempo 2 8").
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/steering.hpp"

namespace percussionist::app {

/// Adds --with; `messages` has to outlive the parsing.
void add_opening_flag(CLI::App& command, std::vector<std::string>& messages);

/// Throws std::invalid_argument naming the message and what was expected.
void obey(Steering& steering, const std::vector<std::string>& messages);

}  // namespace percussionist::app
