#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "app/commands.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

/// Two channels at `rate`, by straight lines between samples: for playing along, not for mastering.
files::Audio stereo(const files::Audio& from, int rate) {
    const auto frames =
        static_cast<std::size_t>(from.samples.size()) / static_cast<std::size_t>(from.channels);
    if (frames == 0) throw std::runtime_error("the recording is empty");
    files::Audio to;
    to.rate = rate;
    to.channels = 2;
    const auto length = static_cast<std::size_t>(static_cast<double>(frames) * rate / from.rate);
    to.samples.reserve(2 * length);
    const auto at = [&](std::size_t frame, int channel) {
        const int c = std::min(channel, from.channels - 1);
        return from.samples[std::min(frame, frames - 1) * static_cast<std::size_t>(from.channels) +
                            static_cast<std::size_t>(c)];
    };
    for (std::size_t i = 0; i < length; ++i) {
        const double place = static_cast<double>(i) * from.rate / rate;
        const auto frame = static_cast<std::size_t>(place);
        const double share = place - std::floor(place);
        for (int c = 0; c < 2; ++c) {
            to.samples.push_back(at(frame, c) + share * (at(frame + 1, c) - at(frame, c)));
        }
    }
    return to;
}

}  // namespace

void add_convert_command(CLI::App& program) {
    struct Options {
        std::filesystem::path from, to;
        int rate = 48000;
    };
    auto options = std::make_shared<Options>();
    CLI::App& command = *program.add_subcommand(
        "convert", "a recording of any kind as a two-channel WAV that Pd plays in time");
    command.add_option("recording", options->from, "audio file")->required();
    command.add_option("-o,--output", options->to, "WAV file")->required();
    command.add_option("--sample-rate", options->rate, "of the WAV [Hz]")
        ->check(CLI::Range(8000, 192000))
        ->capture_default_str();
    command.callback([options] {
        files::write_wav(options->to, stereo(files::read_audio(options->from), options->rate));
    });
}

}  // namespace percussionist::app
