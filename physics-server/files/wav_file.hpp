// Audio files by way of libsndfile: any format it knows in, WAV out.
//
// The same samples give the same bytes: libsndfile's PEAK chunk, which holds the date, is off.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace percussionist::files {

/// what(): the file and what was wrong with it.
struct AudioError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Audio {
    int rate = 48000;  ///< [Hz]
    int channels = 1;
    std::vector<double> samples;  ///< interleaved, full scale being 1
};

enum class SampleFormat { pcm16, float32 };

/// Throws AudioError for what cannot be opened or understood.
Audio read_audio(const std::filesystem::path& path);

/// Beyond full scale 16-bit samples are clipped. Throws AudioError.
void write_wav(const std::filesystem::path& path, const Audio& audio,
               SampleFormat format = SampleFormat::float32);

/// The mean of the channels.
std::vector<double> mono(const Audio& audio);

}  // namespace percussionist::files
