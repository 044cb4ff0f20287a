// One part of a MusicXML score, read measure by measure into notes and tempo marks, in ticks.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/score/nuance.hpp"
#include "core/score/tempo_map.hpp"

namespace percussionist::files {

/// Ticks in a quarter: divisible by what rhythms are made of.
constexpr int kMusicXmlTicks = 10080;

struct MusicXmlNote {
    score::Tick tick = 0;
    double ahead = 0.0;  ///< so much before its tick: a grace note [s]
    int instrument = 38;
    double velocity = 0.63;
    score::Nuance nuance = score::Nuance::legato;
};

struct MusicXmlPart {
    std::vector<MusicXmlNote> notes;
    std::vector<score::TempoChange> tempos;
    std::vector<score::MetreChange> metres;
    score::Tick end = 0;
};

/// `instruments`: General MIDI keys by the ids of <score-instrument>. Never throws for what the
/// document says: what makes no sense counts as not there.
MusicXmlPart read_part(const pugi::xml_node& part, const std::map<std::string, int>& instruments);

}  // namespace percussionist::files
