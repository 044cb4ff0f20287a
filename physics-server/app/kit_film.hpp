// A drummer at a kit as a film: what the pictures are drawn from, and what is heard.
#pragma once

#include <filesystem>

#include "app/film_list.hpp"
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

/// The sound of a plan's strokes, `after` seconds later than theirs, and with them that of a
/// recording (none if `path` is empty), at its sample rate. Throws as reading it does.
files::Audio kit_sound_with(const score::Kit& kit, std::vector<score::KitStroke> strokes,
                            const std::filesystem::path& kit_folder,
                            const std::filesystem::path& recording, double after);

}  // namespace percussionist::app
