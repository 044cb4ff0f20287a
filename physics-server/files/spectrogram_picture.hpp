// A picture of a transcription: the spectrogram above, what was heard in it below.
//
// Each class has a row; a disc at each stroke, the larger the louder and the fainter the less
// sure. Lines mark the attacks in the spectrogram, and beats and bars below. SVG; the spectrogram
// is a PNG within it.
#pragma once

#include <filesystem>
#include <string>

#include "core/listening/beats.hpp"
#include "core/listening/transcription.hpp"

namespace percussionist::files {

/// `title` stands above the picture.
std::string spectrogram_svg(const listening::Transcription& transcription,
                            const listening::Beats& beats, const std::string& title);

}  // namespace percussionist::files
