// The subcommands of the program. Each adds itself to it: its flags, their help, and what it does.
//
// A command that fails throws std::exception with one clear line; main prints it and exits with 1.
#pragma once

#include <CLI/App.hpp>

namespace percussionist::app {

/// serve: the simulation in real time, told and telling over OSC.
void add_serve_command(CLI::App& program);
/// describe: what the server understands over OSC.
void add_describe_command(CLI::App& program);
/// render: the same as fast as it can, into files.
void add_render_command(CLI::App& program);
/// plan: a score as gestures, with pictures; says what cannot be played.
void add_plan_command(CLI::App& program);
/// replay: a recording of serve, played again and compared.
void add_replay_command(CLI::App& program);
/// film: a score played, seen and heard, as a film.
void add_film_command(CLI::App& program);
/// figure: the shapes that the viewer shows.
void add_figure_command(CLI::App& program);
/// animate: a drummer on a whole kit, key-framed, into files.
void add_animate_command(CLI::App& program);
/// check: how well a recording agrees with the contacts of its performance.
void add_check_command(CLI::App& program);
/// samples: the drum's strokes as files, for the patches' sample voice.
void add_samples_command(CLI::App& program);
/// modes: modes measured from recordings, as a mode file, with a picture and a resynthesis.
void add_modes_command(CLI::App& program);
/// drum: the mode file of a drum computed from what it is made of, and strokes of it.
void add_drum_command(CLI::App& program);
/// fastrak-sim: a FASTRAK to try everything on, without hardware. Runs until SIGINT, SIGTERM,
/// "quit" on standard input or --duration.
void add_fastrak_sim_command(CLI::App& program);
/// track: how well the body follows a captured motion.
void add_track_command(CLI::App& program);
/// gestures: the gestures that the body knows; more of them out of recordings.
void add_gestures_command(CLI::App& program);
/// limits: joint limits out of a captured motion.
void add_limits_command(CLI::App& program);
/// convert: a recording as a WAV that Pd plays in time.
void add_convert_command(CLI::App& program);
/// bench: how fast the simulation is.
void add_bench_command(CLI::App& program);

/// transcribe: which drums are struck when in a recording, as MIDI.
void add_transcribe_command(CLI::App& program);
/// learn-drums: what transcribe knows of drums, learnt from pieces the program makes up.
void add_learn_drums_command(CLI::App& program);

}  // namespace percussionist::app
