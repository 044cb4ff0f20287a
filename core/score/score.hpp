// A score: what is to sound, when and how loud; nothing yet about hands.
#pragma once

#include <string>
#include <vector>

#include "core/score/nuance.hpp"
#include "core/score/tempo_map.hpp"

namespace percussionist::score {

struct Note {
    double time = 0.0;      ///< [s] at the score's own tempo
    int instrument = 38;    ///< a General MIDI percussion key, 38 being the snare
    double velocity = 0.5;  ///< above 0 and up to 1: MIDI's 1..127 over 127
    int channel = 9;        ///< 0..15
    Position position;      ///< bar and beat, for reports
    Nuance nuance = Nuance::legato;
};

struct Score {
    std::string title;
    double duration = 0.0;    ///< [s]
    std::vector<Note> notes;  ///< in order of time
    TempoMap tempo;
};

/// What a percussion key of General MIDI is called ("snare", "closed hat"), or "note 93".
std::string instrument_name(int instrument);

/// A piece of some 30 s for two hands on one drum, played when no file is named.
Score built_in_score();

}  // namespace percussionist::score
