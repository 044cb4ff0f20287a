#include "app/kit_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/body_messages.hpp"
#include "app/kit_messages.hpp"
#include "app/kit_score.hpp"
#include "app/kit_sound.hpp"
#include "app/progress.hpp"
#include "app/score_loader.hpp"

namespace percussionist::app {

namespace {

constexpr double kLeadIn = 1.0;   // before the score's time 0 [s]
constexpr double kRingOut = 3.0;  // after the last stroke [s]
constexpr double kStep = 1.0 / 240.0;
/// So loud are recording and kit beside each other, that they do not exceed full scale.
constexpr double kBeside = 0.6;

double end_of(const std::vector<score::KitStroke>& strokes) {
    return (strokes.empty() ? 0.0 : strokes.back().time) + kRingOut;
}

void draw(const std::vector<score::KitStroke>& strokes, body::LiveDrummer& drummer,
          FilmList& list) {
    drummer.load(strokes);
    list.say(osc::encode(scene_message(0.0, drummer.skeleton()), 0.0));
    list.say(osc::encode(kit_message(0.0, drummer.kit()), 0.0));
    score::SongClock song;
    song.play(0.0, -kLeadIn);
    const double length = kLeadIn + end_of(strokes);
    Progress progress("motion");
    for (int i = 1; i * kStep < length; ++i) {
        const double time = i * kStep;
        drummer.step(time, song.advance(time));
        if (!list.due(time)) continue;
        list.say(osc::encode(pose_message(time, drummer.skeleton(), drummer.placement()), 0.0));
        list.say(osc::encode(objects_message(time, drummer), 0.0));
        list.draw();
        progress.tell(time / length);
    }
    progress.done();
}

}  // namespace

files::Audio kit_sound_with(const score::Kit& kit, std::vector<score::KitStroke> strokes,
                            const KitSoundAlong& along) {
    const std::filesystem::path& recording = along.recording;
    const double after = along.after;
    KitSoundOptions options;
    options.folder = along.kit_folder;
    options.rate = along.rate;
    options.duration = after + end_of(strokes);
    files::Audio song;
    if (!recording.empty()) {
        song = files::read_audio(recording);
        options.rate = song.rate;
        const double frames = static_cast<double>(song.samples.size()) / song.channels;
        options.duration = std::max(options.duration, after + frames / song.rate);
    }
    for (score::KitStroke& stroke : strokes) stroke.time += after;
    Progress progress("sound");
    files::Audio all = kit_sound(kit, strokes, options, progress.teller());
    progress.done();
    if (recording.empty()) return all;
    for (double& sample : all.samples) sample *= kBeside;
    const auto first = static_cast<std::size_t>(std::llround(after * song.rate));
    const auto channels = static_cast<std::size_t>(song.channels);
    for (std::size_t i = 0; i < song.samples.size() / channels; ++i) {
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t at = 2 * (first + i) + side;
            if (at >= all.samples.size()) break;
            all.samples[at] += kBeside * song.samples[channels * i + std::min(side, channels - 1)];
        }
    }
    return all;
}

int film_kit(const KitFilmOptions& options, const FilmOptions& film,
             const std::filesystem::path& folder) {
    body::LiveDrummer drummer(load_kit(options.kit));
    const KitScore score = load_kit_score(options.score, drummer.kit());
    for (const std::string& remark : score.remarks) fmt::print(stderr, "{}\n", remark);
    fmt::print("score: {}: {} of {} notes as strokes\n", score.title, score.strokes.size(),
               score.notes);
    std::fflush(stdout);
    return film_strokes(drummer, score.strokes, options, film, folder);
}

int film_strokes(body::LiveDrummer& drummer, const std::vector<score::KitStroke>& strokes,
                 const KitFilmOptions& options, const FilmOptions& film,
                 const std::filesystem::path& folder) {
    FilmList list(folder / "film.txt", film);
    draw(strokes, drummer, list);
    const bool itself = options.audio.empty() && is_recording(options.score);
    files::write_wav(folder / "performance.wav",
                     kit_sound_with(drummer.kit(), strokes,
                                    {std::filesystem::path(options.kit).parent_path(),
                                     itself ? options.score : options.audio, kLeadIn}));
    return list.finish();
}

}  // namespace percussionist::app
