#include "files/wav_file.hpp"

#include <sndfile.h>

#include <algorithm>
#include <memory>
#include <string>

namespace percussionist::files {

namespace {

struct Close {
    void operator()(SNDFILE* file) const { sf_close(file); }
};
using File = std::unique_ptr<SNDFILE, Close>;

/// Some 90 minutes of stereo at 48 kHz, 4 GB in memory; compressed silence could claim any number.
constexpr sf_count_t kMostSamples = 500'000'000;

File open(const std::filesystem::path& path, int mode, SF_INFO& info) {
    File file(sf_open(path.c_str(), mode, &info));
    if (!file) {
        throw AudioError(path.string() + ": " + sf_strerror(nullptr));
    }
    return file;
}

void refuse_longer(const std::filesystem::path& path, const SF_INFO& info, sf_count_t most_frames) {
    if (info.frames < 0 || info.frames > most_frames) {
        throw AudioError(path.string() + ": expected at most " + std::to_string(most_frames) +
                         " frames, found " + std::to_string(info.frames));
    }
}

template <class Take>
void read_pieces(const std::filesystem::path& path, SNDFILE* file, const SF_INFO& info, Take take) {
    // In pieces, so that a header that promises too much, frames or channels, takes no memory for
    // it.
    const sf_count_t most = std::max<sf_count_t>(1, 65536 / info.channels);
    const sf_count_t frames = std::clamp<sf_count_t>(info.frames, 1, most);
    std::vector<double> piece(static_cast<std::size_t>(frames * info.channels));
    for (sf_count_t got = 1; got > 0;) {
        got = sf_readf_double(file, piece.data(), frames);
        take(std::span<const double>(piece).first(static_cast<std::size_t>(got * info.channels)));
    }
    if (sf_error(file) != SF_ERR_NO_ERROR) {
        throw AudioError(path.string() + ": " + sf_strerror(file));
    }
}

/// The mean of the channels of each frame.
void mix(std::span<const double> frames, std::size_t channels, std::vector<double>& mean) {
    mean.resize(frames.size() / channels);
    for (std::size_t i = 0; i < mean.size(); ++i) {
        double sum = 0.0;
        for (std::size_t c = 0; c < channels; ++c) sum += frames[i * channels + c];
        mean[i] = sum / static_cast<double>(channels);
    }
}

}  // namespace

Audio read_audio(const std::filesystem::path& path) {
    SF_INFO info{};
    const File file = open(path, SFM_READ, info);
    refuse_longer(path, info, kMostSamples / info.channels);
    Audio audio{.rate = info.samplerate, .channels = info.channels, .samples = {}};
    read_pieces(path, file.get(), info, [&](std::span<const double> piece) {
        audio.samples.insert(audio.samples.end(), piece.begin(), piece.end());
    });
    return audio;
}

int rate_of(const std::filesystem::path& path) {
    SF_INFO info{};
    const File file = open(path, SFM_READ, info);
    return info.samplerate;
}

void play_mono(const std::filesystem::path& path,
               const std::function<void(std::span<const double>)>& take) {
    SF_INFO info{};
    const File file = open(path, SFM_READ, info);
    refuse_longer(path, info, kMostSamples);
    std::vector<double> mean;
    read_pieces(path, file.get(), info, [&](std::span<const double> piece) {
        mix(piece, static_cast<std::size_t>(info.channels), mean);
        take(mean);
    });
}

void write_wav(const std::filesystem::path& path, const Audio& audio, SampleFormat format) {
    if (audio.rate <= 0 || audio.channels <= 0 ||
        audio.samples.size() % static_cast<std::size_t>(audio.channels) != 0) {
        throw AudioError(path.string() + ": cannot write " + std::to_string(audio.samples.size()) +
                         " samples as " + std::to_string(audio.channels) + " channels at " +
                         std::to_string(audio.rate) + " Hz");
    }
    SF_INFO info{};
    info.samplerate = audio.rate;
    info.channels = audio.channels;
    info.format =
        SF_FORMAT_WAV | (format == SampleFormat::pcm16 ? SF_FORMAT_PCM_16 : SF_FORMAT_FLOAT);
    File file = open(path, SFM_WRITE, info);
    sf_command(file.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    sf_command(file.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
    const auto count = static_cast<sf_count_t>(audio.samples.size());
    if (sf_write_double(file.get(), audio.samples.data(), count) != count) {
        throw AudioError(path.string() + ": " + sf_strerror(file.get()));
    }
    sf_write_sync(file.get());
}

std::vector<double> mono(const Audio& audio) {
    std::vector<double> mean;
    mix(audio.samples, static_cast<std::size_t>(audio.channels), mean);
    return mean;
}

}  // namespace percussionist::files
