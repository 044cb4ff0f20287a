#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/drum_sound.hpp"
#include "app/film_list.hpp"
#include "app/film_pictures.hpp"
#include "app/kit_film.hpp"
#include "app/opening_messages.hpp"
#include "app/performance.hpp"
#include "app/simulation_flags.hpp"
#include "app/temporary_folder.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

struct FilmCommandOptions {
    std::filesystem::path score, film;
    std::filesystem::path project = project_folder();
    std::vector<std::string> messages;
    FilmOptions film_options;
    sim::SimulationOptions simulation;
    std::optional<KitFilmOptions> kit;  ///< none: one drum
};

/// What is drawn, and heard, in a folder; says what it was.
struct Filmed {
    int pictures = 0;
    std::string report;
};

Filmed film_drum(const FilmCommandOptions& options, const std::filesystem::path& work) {
    LoadedScore score = load_score(options.score, options.simulation.person);
    for (const std::string& remark : score.remarks) fmt::print(stderr, "{}\n", remark);
    fmt::print("score: {}: {} of {} notes as strokes\n", score.title, score.strokes.size(),
               score.notes);
    std::fflush(stdout);
    Performance performance(options.simulation);
    const sim::Simulation& simulation = performance.simulation();
    performance.load(std::move(score.strokes), score.motion);
    Steering steering(performance, body::built_in_gestures());
    obey(steering, options.messages);
    FilmList list(work / "film.txt", options.film_options);
    list.scene(simulation, simulation.options().head.membrane.radius);
    performance.play();
    while (performance.playing()) {
        for (const LoggedContact& contact : performance.step()) list.contact(contact.event);
        list.stepped(simulation);
    }
    constexpr int kSampleRate = 48000;
    files::write_wav(work / "performance.wav", drum_sound(performance.log(), simulation.time(),
                                                          kSampleRate, simulation.options().head));
    return {list.finish(), describe(performance.summary())};
}

void film(const FilmCommandOptions& options) {
    const TemporaryFolder work;
    const Filmed filmed =
        options.kit ? Filmed{film_kit(*options.kit, options.film_options, work.path()), ""}
                    : film_drum(options, work.path());
    make_film(work.path(), filmed.pictures, options.film_options.rate, options.film,
              options.project);
    fmt::print("{}pictures           {}\n", filmed.report, filmed.pictures);
}

std::string even(const std::string& text) {
    return std::atoi(text.c_str()) % 2 == 0 ? "" : "expected an even number, got " + text;
}

}  // namespace

void add_film_command(CLI::App& program) {
    auto options = std::make_shared<FilmCommandOptions>();
    FilmOptions& film_options = options->film_options;
    CLI::App& command = *program.add_subcommand(
        "film",
        "play a score into a film with sound; needs no screen, and Pd, Gem, Xvfb and ffmpeg");
    command.add_option(
        "score", options->score,
        "a MIDI or MusicXML file, a recording, or captured motion (BVH, CSV of sticks); none: "
        "the built-in piece");
    auto kit = std::make_shared<KitFilmOptions>();
    CLI::Option* with_kit =
        command
            .add_option("--kit", kit->kit,
                        "a drummer at a whole kit, key-framed: a kit file; none: the standard kit")
            ->expected(0, 1);
    command
        .add_option("--audio", kit->audio,
                    "a recording that is heard beside the kit, in time; a score that is one is so "
                    "by itself")
        ->needs(with_kit);
    command.add_option("-o,--output", options->film, "the film, FILE.mp4")->required();
    add_opening_flag(command, options->messages);
    command.add_option("--pictures", film_options.rate, "a second")
        ->check(CLI::IsMember({10, 12, 15, 20, 30, 60}))
        ->capture_default_str();
    for (auto [flag, size] :
         {std::pair{"--width", &film_options.width}, std::pair{"--height", &film_options.height}}) {
        command.add_option(flag, *size, "of a picture, even [pixels]")
            ->check(CLI::Range(160, 2048))
            ->check(CLI::Validator(even, "EVEN"))
            ->capture_default_str();
    }
    command.add_option("--azimuth", film_options.azimuth, "of the camera [degrees]")
        ->check(CLI::Range(-180.0, 180.0))
        ->capture_default_str();
    command.add_option("--elevation", film_options.elevation, "of the camera [degrees]")
        ->check(CLI::Range(-10.0, 85.0))
        ->capture_default_str();
    command.add_option("--distance", film_options.distance, "of the camera from the drum [m]")
        ->check(CLI::Range(0.6, 8.0))
        ->capture_default_str();
    command.add_option("--project", options->project, "the folder with patches/ and scripts/")
        ->capture_default_str();
    add_simulation_flags(command, options->simulation);
    command.callback([options, kit, with_kit] {
        if (with_kit->count() > 0) {
            options->kit = *kit;
            options->kit->score = options->score;
        }
        film(*options);
    });
}

}  // namespace percussionist::app
