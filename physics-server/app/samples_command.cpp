#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/kit_score.hpp"
#include "app/kit_sound.hpp"
#include "app/progress.hpp"
#include "core/modal/modal_drum.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

/// Speeds of the strokes, softest first [m/s]: the layers that the patches choose from.
constexpr std::array kSpeeds{0.7, 1.1, 1.7, 2.6, 4.0};
constexpr double kSeconds = 3.0;
constexpr double kFade = 0.05;

void fade_out(files::Audio& audio) {
    const auto fade = static_cast<std::size_t>(kFade * audio.rate) * audio.channels;
    for (std::size_t i = 0; i < fade; ++i) {
        audio.samples[audio.samples.size() - 1 - i] *=
            static_cast<double>(i) / static_cast<double>(fade);
    }
}

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
    fade_out(audio);
    return audio;
}

/// Velocities of a kit's strokes, softest first: patches/voice/kit-event.pd knows their speeds.
constexpr std::array kVelocities{0.25, 0.55, 1.0};

/// A stroke of each event, soft to hard, into EVENT-1.wav and so on; in stereo.
void write_kit_samples(const std::filesystem::path& folder, const std::string& file, int rate) {
    const score::Kit kit = load_kit(file);
    KitSoundOptions sound;
    sound.rate = rate;
    sound.folder = std::filesystem::path(file).parent_path();
    sound.duration = kSeconds;
    Progress progress("strokes");
    for (std::size_t e = 0; e < kit.events.size(); ++e) {
        for (std::size_t i = 0; i < kVelocities.size(); ++i) {
            const score::Limb limb = kit.events[e].foot.value_or(score::Limb::right_hand);
            const score::KitStroke stroke{0.0, limb, e, kVelocities[i], 0, false, {}};
            files::Audio audio = kit_sound(kit, std::span(&stroke, 1), sound);
            fade_out(audio);
            files::write_wav(folder / fmt::format("{}-{}.wav", kit.events[e].name, i + 1), audio);
        }
        progress.tell(static_cast<double>(e + 1) / static_cast<double>(kit.events.size()));
    }
    progress.done();
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
    auto kit = std::make_shared<std::string>();
    CLI::Option* with_kit =
        command
            .add_option("--kit", *kit,
                        "instead each event of a kit, into EVENT-1.wav .. EVENT-3.wav: a kit file; "
                        "none: the standard kit")
            ->expected(0, 1);
    command.callback([options, kit, with_kit] {
        std::filesystem::create_directories(options->folder);
        if (with_kit->count() > 0) {
            write_kit_samples(options->folder, *kit, options->rate);
            return;
        }
        for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
            files::write_wav(options->folder / fmt::format("stroke-{}.wav", i + 1),
                             stroke_sound(kSpeeds[i], options->rate));
        }
    });
}

}  // namespace percussionist::app
