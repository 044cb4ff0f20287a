// From what is drawn and heard to a film: Pd and Gem draw its pictures without a screen, ffmpeg
// joins them with the sound (scripts/film-pictures).
#pragma once

#include <filesystem>

namespace percussionist::app {

/// Where patches/ and scripts/ are: where the program was installed, or where it was built from.
std::filesystem::path project_folder();

/// `work` holds film.txt (FilmList) and performance.wav. Throws std::runtime_error if the script
/// cannot be run, or fails; it has said then what is missing.
void make_film(const std::filesystem::path& work, int pictures, int rate,
               const std::filesystem::path& film, const std::filesystem::path& project);

}  // namespace percussionist::app
