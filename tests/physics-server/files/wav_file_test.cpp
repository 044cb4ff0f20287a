#include "files/wav_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "support/real_data.hpp"

using namespace percussionist;
using namespace percussionist::files;

namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("percussionist_wav_test_" + name);
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Audio tone(int channels) {
    Audio audio{44100, channels, {}};
    for (int n = 0; n < 1000; ++n) {
        for (int c = 0; c < channels; ++c) {
            audio.samples.push_back(0.9 * std::sin(0.01 * n * (c + 1)));
        }
    }
    return audio;
}

}  // namespace

TEST_CASE("what is written is read again, to the precision of the format") {
    const auto path = scratch("again.wav");
    for (const auto& [format, error] :
         {std::pair{SampleFormat::float32, 6e-8}, std::pair{SampleFormat::pcm16, 1.0 / 32767}}) {
        const Audio audio = tone(2);
        write_wav(path, audio, format);
        const Audio read = read_audio(path);
        CHECK(read.rate == 44100);
        CHECK(read.channels == 2);
        REQUIRE(read.samples.size() == audio.samples.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < audio.samples.size(); ++i) {
            worst = std::max(worst, std::abs(read.samples[i] - audio.samples[i]));
        }
        CHECK(worst <= error);
    }
    std::filesystem::remove(path);
}

TEST_CASE("the same samples are the same bytes, now and later") {
    const auto path = scratch("bytes.wav");
    for (const SampleFormat format : {SampleFormat::float32, SampleFormat::pcm16}) {
        write_wav(path, tone(1), format);
        const std::string first = bytes_of(path);
        CHECK(first.find("PEAK") == std::string::npos);  // it would hold the time of writing
        write_wav(path, tone(1), format);
        CHECK(bytes_of(path) == first);
        CHECK(first.size() > 2000);
    }
    std::filesystem::remove(path);
}

TEST_CASE("16-bit samples beyond full scale are clipped, not wrapped") {
    const auto path = scratch("clip.wav");
    write_wav(path, {48000, 1, {2.0, -2.0}}, SampleFormat::pcm16);
    const Audio read = read_audio(path);
    CHECK(read.samples.at(0) > 0.99);
    CHECK(read.samples.at(1) == -1.0);
    std::filesystem::remove(path);
}

TEST_CASE("mono is the mean of the channels") {
    CHECK(mono({48000, 2, {1.0, 0.0, 0.5, -0.5}}) == std::vector<double>{0.5, 0.0});
    CHECK(mono({48000, 1, {1.0, 2.0}}) == std::vector<double>{1.0, 2.0});
}

TEST_CASE("played piece after piece a file is what it is read as") {
    const auto path = scratch("pieces.wav");
    Audio audio{44100, 3, {}};
    for (int n = 0; n < 3 * 70000; ++n) audio.samples.push_back(0.001 * (n % 777));
    write_wav(path, audio);
    std::vector<double> played;
    play_mono(path, [&](std::span<const double> piece) {
        played.insert(played.end(), piece.begin(), piece.end());
    });
    CHECK(played == mono(read_audio(path)));
    CHECK(rate_of(path) == 44100);
    std::filesystem::remove(path);
}

TEST_CASE("what cannot be read or written is named") {
    const auto names = [](const auto& action, const std::string& name) {
        try {
            action();
        } catch (const AudioError& error) {
            return std::string(error.what()).find(name) == 0;
        }
        return false;
    };
    const auto path = scratch("rubbish.wav");
    std::ofstream(path) << "this is no audio";
    CHECK(names([&] { read_audio(path); }, path.string()));
    CHECK(names([] { read_audio("/no/such.wav"); }, "/no/such.wav"));
    CHECK(names([] { write_wav("/no/such.wav", tone(1)); }, "/no/such.wav"));
    CHECK(names([] { write_wav("/tmp/x.wav", {48000, 2, {1.0}}); }, "/tmp/x.wav"));
    CHECK(names(
        [] {
            write_wav("/tmp/x.wav", {0, 1, {1.0}});
        },
        "/tmp/x.wav: cannot write 1 samples as 1 channels at 0 Hz"));
    std::filesystem::remove(path);
}

TEST_CASE("a WAV file cut anywhere is read as far as it goes or refused") {
    const auto path = scratch("cut.wav");
    write_wav(path, tone(2));
    const std::string whole = bytes_of(path);
    for (std::size_t size = 0; size < whole.size(); size += size < 100 ? 1 : 997) {
        std::ofstream(path, std::ios::binary) << whole.substr(0, size);
        try {
            const Audio audio = read_audio(path);
            CHECK(audio.samples.size() <= 2000);
        } catch (const AudioError&) {
            CHECK(size < 100);
        }
    }
    std::filesystem::remove(path);
}

TEST_CASE("real recordings are read") {
    for (const auto& path : test::real_files("drum-audio", ".wav")) {
        CAPTURE(path.string());
        const Audio audio = read_audio(path);
        CHECK(audio.rate == 44100);
        CHECK(mono(audio).size() > 10 * 44100);
    }
}
