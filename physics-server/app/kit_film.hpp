// A drummer at a kit as a film: what the pictures are drawn from, and what is heard.
#pragma once

#include <filesystem>

#include "app/film_list.hpp"
#include "body/live_drummer.hpp"
#include "core/score/kit_plan.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

struct KitFilmOptions {
    std::filesystem::path score;
    std::string kit;              ///< a file; empty: the standard kit
    std::filesystem::path audio;  ///< heard beside the kit; empty: the score, if it is a recording
};

/// Writes film.txt and performance.wav into `folder`; how many pictures that makes.
int film_kit(const KitFilmOptions& options, const FilmOptions& film,
             const std::filesystem::path& folder);

/// The same of strokes that are planned already, on the drummer's kit; the score is not read.
int film_strokes(body::LiveDrummer& drummer, const std::vector<score::KitStroke>& strokes,
                 const KitFilmOptions& options, const FilmOptions& film,
                 const std::filesystem::path& folder);

struct KitSoundAlong {
    std::filesystem::path kit_folder;  ///< where mode files that the kit names are
    std::filesystem::path recording;   ///< heard beside it; empty: none
    double after = 0.0;                ///< so much later than its time all is [s]
    int rate = 48000;                  ///< [Hz], where there is no recording, which has its own
};

/// The sound of a plan's strokes, and with it that of a recording. Throws as reading it does.
files::Audio kit_sound_with(const score::Kit& kit, std::vector<score::KitStroke> strokes,
                            const KitSoundAlong& along);

}  // namespace percussionist::app
