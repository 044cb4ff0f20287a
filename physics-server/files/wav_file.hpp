// Audio files by way of libsndfile: any format it knows in, WAV out.
//
// The same samples give the same bytes: libsndfile's PEAK chunk, which holds the date, is off.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
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

/// The rate of a file [Hz]. Throws as read_audio() does.
int rate_of(const std::filesystem::path& path);
/// The mean of a file's channels, piece after piece, however long it is. Throws as read_audio()
/// does.
void play_mono(const std::filesystem::path& path,
               const std::function<void(std::span<const double>)>& take);

/// Beyond full scale 16-bit samples are clipped. Throws AudioError.
void write_wav(const std::filesystem::path& path, const Audio& audio,
               SampleFormat format = SampleFormat::float32);

/// The mean of the channels.
std::vector<double> mono(const Audio& audio);

}  // namespace percussionist::files
