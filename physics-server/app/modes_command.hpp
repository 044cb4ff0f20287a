// percussionist modes: modes measured from recordings. percussionist drum: a drum of the set.
#pragma once

namespace CLI {
class App;
}

namespace percussionist::app {

/// modes HIT.wav... --positions R,... -o FILE: a mode file out of recordings, with a picture and a
/// resynthesis. Its callback throws std::runtime_error with one line.
void add_modes_command(CLI::App& program);

/// drum NAME -o FILE: the mode file of a drum computed from what it is made of, and, if wanted,
/// what `modes` is tried on: recordings of it struck at several places. Throws likewise.
void add_drum_command(CLI::App& program);

}  // namespace percussionist::app
