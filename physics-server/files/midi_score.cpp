#include <algorithm>

#include "files/midi_file.hpp"

namespace percussionist::files {

score::Score midi_to_score(const MidiFile& file) {
    score::Score score;
    score.title = file.title.empty() ? file.name : file.title;
    score.tempo = score::TempoMap(file.division, file.tempos, file.metres);
    score.duration = score.tempo.seconds(file.end);
    const bool any = std::any_of(file.notes.begin(), file.notes.end(),
                                 [](const MidiNote& note) { return note.percussion; });
    constexpr double kLoudest = 127.0;
    for (const MidiNote& note : file.notes) {
        if (note.percussion || !any) {
            score.notes.push_back({score.tempo.seconds(note.tick), note.key,
                                   note.velocity / kLoudest, note.channel,
                                   score.tempo.position(note.tick)});
        }
    }
    return score;
}

}  // namespace percussionist::files
