#include <array>
#include <string_view>

#include "core/score/score.hpp"

namespace percussionist::score {

namespace {

constexpr int kFirst = 35;
/// General MIDI Level 1 percussion, keys 35 to 81.
constexpr std::array<std::string_view, 47> kNames = {
    "low kick",       "kick",           "side stick",    "snare",        "clap",
    "electric snare", "low floor tom",  "closed hat",    "floor tom",    "pedal hat",
    "low tom",        "open hat",       "low mid tom",   "high mid tom", "crash",
    "high tom",       "ride",           "china",         "ride bell",    "tambourine",
    "splash",         "cowbell",        "second crash",  "vibraslap",    "second ride",
    "high bongo",     "low bongo",      "muted conga",   "high conga",   "low conga",
    "high timbale",   "low timbale",    "high agogo",    "low agogo",    "cabasa",
    "maracas",        "short whistle",  "long whistle",  "short guiro",  "long guiro",
    "claves",         "high woodblock", "low woodblock", "muted cuica",  "open cuica",
    "muted triangle", "open triangle"};

}  // namespace

std::string instrument_name(int instrument) {
    // Electronic kits send the edge of the hi-hat as two keys of their own.
    if (instrument == 22 || instrument == 26) {
        return instrument == 22 ? "closed hat edge" : "open hat edge";
    }
    const int index = instrument - kFirst;
    if (index < 0 || index >= static_cast<int>(kNames.size())) {
        return "note " + std::to_string(instrument);
    }
    return std::string(kNames[index]);
}

}  // namespace percussionist::score
