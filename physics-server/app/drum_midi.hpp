// A transcription as MIDI: beats become quarter notes, so that bars are bars in any editor, and
// strokes keep the time at which they sounded.
#pragma once

#include <string>

#include "core/listening/beats.hpp"
#include "core/listening/transcription.hpp"
#include "files/midi_file.hpp"

namespace percussionist::app {

/// The General MIDI key of a stroke: toms by their pitch, what is none of the kit as side stick.
int midi_key(const listening::DrumStroke& stroke);

/// On channel 10. Ticks begin at the recording's first sample.
files::MidiFile to_midi(const listening::Transcription& transcription,
                        const listening::Beats& beats, const std::string& title);

/// "time_s,drum,key,velocity,confidence", a line for each stroke.
std::string to_csv(const listening::Transcription& transcription);

}  // namespace percussionist::app
