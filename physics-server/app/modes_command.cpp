#include "app/commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "app/modes_picture.hpp"
#include "core/modal/decay.hpp"
#include "core/modal/mode_file.hpp"
#include "core/modal/modes_of_hits.hpp"
#include "files/text_file.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

struct ModesOptions {
    std::vector<std::string> recordings;
    std::vector<double> positions;
    std::string output;
    std::string picture;
    std::string resynthesis;
    std::string name = "measured";
    modal::HitAnalysis analysis;
};

std::vector<modal::Hit> read_hits(const ModesOptions& options, int& rate) {
    if (options.recordings.size() != options.positions.size()) {
        throw std::runtime_error(fmt::format("modes: {} recordings, but {} positions",
                                             options.recordings.size(), options.positions.size()));
    }
    std::vector<modal::Hit> hits;
    for (std::size_t i = 0; i < options.recordings.size(); ++i) {
        const auto audio = files::read_audio(options.recordings[i]);
        if (i > 0 && audio.rate != rate) {
            throw std::runtime_error(fmt::format("{}: {} Hz, but the first recording has {} Hz",
                                                 options.recordings[i], audio.rate, rate));
        }
        rate = audio.rate;
        hits.push_back({options.positions[i], files::mono(audio)});
    }
    return hits;
}

/// As long as the recordings, the strokes where theirs are.
void write_resynthesis(const ModesOptions& options, const modal::MeasuredModes& measured,
                       const std::vector<modal::Hit>& hits, int rate) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const std::size_t begin = measured.begins[i];
        files::Audio audio;
        audio.rate = rate;
        audio.samples.assign(begin, 0.0);
        const auto sound = modal::resynthesis(measured.sines, measured.amplitudes[i],
                                              hits[i].samples.size() - begin, rate);
        audio.samples.insert(audio.samples.end(), sound.begin(), sound.end());
        files::write_wav(fmt::format("{}{}.wav", options.resynthesis, i), audio);
    }
}

void report(const modal::MeasuredModes& measured, const std::vector<modal::Hit>& hits,
            double high) {
    fmt::print("{:>10} {:>8}  weights, the largest being 1, at", "Hz", "t60 s");
    for (const double place : measured.modes.places) {
        fmt::print(" {:g}", place);
    }
    fmt::print("\n");
    for (const auto& mode : measured.modes.modes) {
        fmt::print("{:10.2f} {:8.3f} ", mode.frequency, mode.t60);
        for (const double weight : mode.weights) {
            fmt::print(" {:6.2f}", weight * std::sqrt(modal::kTypicalMass));
        }
        fmt::print("\n");
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        fmt::print(
            "recording {}: what the modes do not explain is {:.1f} dB of it, up to {:g} Hz\n",
            i + 1, 10 * std::log10(std::max(measured.left[i], 1e-30)), high);
    }
    fmt::print("{} modes; {} signs not known\n", measured.modes.modes.size(),
               measured.unknown_signs);
}

void run_modes(const ModesOptions& options) {
    int rate = 0;
    const auto hits = read_hits(options, rate);
    auto measured = modal::modes_of_hits(hits, rate, options.analysis);
    measured.modes.name = options.name;
    measured.modes.origin = fmt::format(
        "measured from {} recordings; the scale of its weights is not known", hits.size());
    files::write_text(options.output, modal::write_modes(measured.modes));
    if (!options.picture.empty()) {
        draw_modes(options.picture, measured, hits, rate);
    }
    if (!options.resynthesis.empty()) {
        write_resynthesis(options, measured, hits, rate);
    }
    report(measured, hits, options.analysis.high);
}

/// Core throws std::invalid_argument; main prints what(), whichever.
template <class Options>
void on_command(CLI::App* command, const std::shared_ptr<Options>& options,
                void (*run)(const Options&)) {
    command->callback([options, run] {
        try {
            run(*options);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(error.what());
        }
    });
}

}  // namespace

void add_modes_command(CLI::App& program) {
    auto options = std::make_shared<ModesOptions>();
    auto& o = *options;
    auto* const command = program.add_subcommand(
        "modes", "Measures a drum's modes from recordings of single strokes at known places");
    command->add_option("recordings", o.recordings, "One recording of one stroke for each place")
        ->required();
    command->add_option("--positions", o.positions, "Where each was struck: r over radius, 0 to 1")
        ->required()
        ->delimiter(',');
    command->add_option("-o,--output", o.output, "The mode file to write")->required();
    command->add_option("--picture", o.picture, "An SVG picture: spectrum, modes found, decays");
    command->add_option("--resynthesis", o.resynthesis,
                        "Recordings made of the modes: PREFIX0.wav, PREFIX1.wav ...");
    command->add_option("--name", o.name, "The drum's name in the mode file");
    command->add_option("--radius", o.analysis.radius, "Of the drum [m]");
    command->add_option("--low", o.analysis.low, "Modes from [Hz]");
    command->add_option("--high", o.analysis.high, "Modes to [Hz]");
    command->add_option("--most", o.analysis.most, "The strongest modes kept");
    command->add_option("--skip", o.analysis.skip,
                        "Of each stroke, while the stick still touches [s]");
    on_command(command, options, run_modes);
}

}  // namespace percussionist::app
