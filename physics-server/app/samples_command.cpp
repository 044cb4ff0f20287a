#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "core/modal/modal_drum.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

/// Speeds of the strokes, softest first [m/s]: the layers that the patches choose from.
constexpr std::array kSpeeds{0.7, 1.1, 1.7, 2.6, 4.0};
constexpr double kSeconds = 3.0;
constexpr double kFade = 0.05;

files::Audio stroke_sound(double speed, int rate) {
    const modal::DrumSettings settings;
    modal::ModalDrum drum(settings, rate);
    modal::Stroke stroke;
    stroke.velocity = speed;
    stroke.r = 0.75 * modal::Membrane{}.radius;
    stroke.theta = 2.81;
    drum.strike(0, stroke);
    files::Audio audio;
    audio.rate = rate;
    audio.samples.resize(static_cast<std::size_t>(kSeconds * rate));
    drum.process(std::span(audio.samples));
    const auto fade = static_cast<std::size_t>(kFade * rate);
    for (std::size_t i = 0; i < fade; ++i) {
        audio.samples[audio.samples.size() - 1 - i] *=
            static_cast<double>(i) / static_cast<double>(fade);
    }
    return audio;
}

}  // namespace

void add_samples_command(CLI::App& program) {
    struct Options {
        std::filesystem::path folder;
        int rate = 48000;
    };
    auto options = std::make_shared<Options>();
    CLI::App& command = *program.add_subcommand(
        "samples", "render the drum's strokes, soft to hard, into stroke-1.wav .. stroke-5.wav");
    command.add_option("-o,--output", options->folder, "folder for the files")->required();
    command.add_option("--sample-rate", options->rate, "of the sound [Hz]")
        ->check(CLI::Range(8000, 192000))
        ->capture_default_str();
    command.callback([options] {
        std::filesystem::create_directories(options->folder);
        for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
            files::write_wav(options->folder / fmt::format("stroke-{}.wav", i + 1),
                             stroke_sound(kSpeeds[i], options->rate));
        }
    });
}

}  // namespace percussionist::app
