// Recordings that transcribe has to bear: a piece for drums in many formats and states, and what
// holds no drums.
//
//     odd-recordings FOLDER
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/listening/practice/dice.hpp"
#include "core/listening/practice/piece_of_music.hpp"

using namespace percussionist::listening::practice;

namespace {

using Signal = std::vector<double>;
constexpr double kTau = 2.0 * std::numbers::pi;
constexpr int kRate = 44100;

struct Format {
    int kind = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    int rate = kRate;
    int channels = 1;
};

class Folder {
  public:
    explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

    void write(const char* name, const Signal& signal, const Format& format = {}) const {
        SF_INFO info{};
        info.samplerate = format.rate;
        info.channels = format.channels;
        info.format = format.kind;
        SNDFILE* const file = sf_open((path_ / name).c_str(), SFM_WRITE, &info);
        sf_command(file, SFC_SET_CLIPPING, nullptr, SF_TRUE);
        Signal frame(static_cast<std::size_t>(format.channels));
        for (const double x : signal) {
            std::fill(frame.begin(), frame.end(), x);
            sf_writef_double(file, frame.data(), 1);
        }
        sf_close(file);
    }
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

/// By linear interpolation: dull, but in time.
Signal at_rate(const Signal& signal, double rate) {
    Signal made(static_cast<std::size_t>(static_cast<double>(signal.size() - 1) * rate / kRate));
    for (std::size_t n = 0; n < made.size(); ++n) {
        const double at = static_cast<double>(n) * kRate / rate;
        const auto whole = static_cast<std::size_t>(at);
        const double part = at - static_cast<double>(whole);
        made[n] = (1.0 - part) * signal[whole] + part * signal[whole + 1];
    }
    return made;
}

template <class Change>
Signal changed(Signal signal, Change change) {
    for (double& x : signal) x = change(x);
    return signal;
}

template <class Wave>
Signal seconds(double duration, Wave wave) {
    Signal made(static_cast<std::size_t>(duration * kRate));
    for (std::size_t n = 0; n < made.size(); ++n) made[n] = wave(static_cast<double>(n) / kRate);
    return made;
}

/// Vowels of two resonances and hisses between, at no regular times.
Signal spoken(double duration, Dice& dice) {
    Signal made(static_cast<std::size_t>(duration * kRate), 0.0);
    for (double t = 0.3; t + 0.6 < duration;) {
        const double hiss = dice.uniform(0.04, 0.15), vowel = dice.uniform(0.08, 0.3);
        const double pitch = dice.uniform(95.0, 150.0);
        const double low = dice.uniform(300.0, 800.0), high = dice.uniform(900.0, 2200.0);
        double before = 0.0;
        for (std::size_t n = 0; n < static_cast<std::size_t>((hiss + vowel) * kRate); ++n) {
            const double age = static_cast<double>(n) / kRate;
            double& out = made[static_cast<std::size_t>(t * kRate) + n];
            if (age < hiss) {
                const double noise = dice.uniform(-1.0, 1.0);
                out += 0.15 * std::sin(0.5 * kTau * age / hiss) * (noise - before);
                before = noise;
            } else {
                const double since = age - hiss;
                const double pulse = std::fmod(since * pitch, 1.0) / pitch;
                const double edge = std::min({since / 0.03, (vowel - since) / 0.04, 1.0});
                out += 0.3 * edge * std::exp(-pulse * 300.0) *
                       (std::sin(kTau * low * pulse) + 0.5 * std::sin(kTau * high * pulse));
            }
        }
        t += hiss + vowel + (dice.chance(0.3) ? dice.uniform(0.2, 0.6) : dice.uniform(0.0, 0.05));
    }
    return made;
}

Signal drums() {
    for (std::uint64_t seed = 3;; ++seed) {
        PieceOfMusic piece = piece_of_music(seed, 8.0);
        if (piece.alone && piece.strokes.size() > 40) return std::move(piece.signal);
    }
}

void write_drums(const Folder& folder) {
    const Signal piece = drums();
    folder.write("drums.wav", piece);
    folder.write("drums.flac", piece, {.kind = SF_FORMAT_FLAC | SF_FORMAT_PCM_16});
    folder.write("drums.ogg", piece, {.kind = SF_FORMAT_OGG | SF_FORMAT_VORBIS});
    folder.write("drums-8k.wav", at_rate(piece, 8000.0), {.rate = 8000});
    folder.write("drums-96k.wav", at_rate(piece, 96000.0),
                 {.kind = SF_FORMAT_WAV | SF_FORMAT_PCM_24, .rate = 96000, .channels = 8});
    folder.write("drums-quiet.wav", changed(piece, [](double x) { return 0.001 * x; }),
                 {.kind = SF_FORMAT_WAV | SF_FORMAT_PCM_24});
    folder.write("drums-clipped.wav",
                 changed(piece, [](double x) { return std::clamp(8.0 * x, -1.0, 1.0); }));
    folder.write("drums-offset.wav", changed(piece, [](double x) { return 0.5 * x + 0.3; }));
    folder.write("drums-cut.wav", piece);
    std::filesystem::resize_file(folder / "drums-cut.wav",
                                 std::filesystem::file_size(folder / "drums-cut.wav") / 2 + 1);
    Signal broken = piece;
    broken[12345] = std::numeric_limits<double>::quiet_NaN();
    folder.write("nan.wav", broken, {.kind = SF_FORMAT_WAV | SF_FORMAT_FLOAT});
}

void write_the_rest(const Folder& folder) {
    Dice dice(11);
    folder.write("silence.wav", Signal(3 * kRate, 0.0));
    folder.write("sweep.wav", seconds(6.0, [](double t) {
                     return 0.5 * std::sin(kTau * 30.0 * (std::exp(t) - 1.0));
                 }));
    folder.write("noise.wav", seconds(6.0, [&](double) { return dice.uniform(-0.5, 0.5); }));
    folder.write("speech.wav", spoken(20.0, dice));
    folder.write("click.wav", seconds(2.0, [](double t) { return t == 1.0 ? 0.9 : 0.0; }));
    folder.write("sample.wav", {0.7});
    folder.write("none.wav", {});
    folder.write("slow.wav", Signal(4000, 0.1), {.rate = 4000});
    std::ofstream(folder / "empty.wav");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("odd-recordings FOLDER\n", stderr);
        return 2;
    }
    const Folder folder(argv[1]);
    write_drums(folder);
    write_the_rest(folder);
}
