// The flags that every command with a clip has.
#pragma once

#include <CLI/App.hpp>

#include "app/clip_loader.hpp"

namespace percussionist::app {

/// Adds the clip's files, --map, --unit and the like; `options` has to outlive the parsing.
void add_clip_flags(CLI::App& command, ClipOptions& options);

}  // namespace percussionist::app
