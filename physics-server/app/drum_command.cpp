// percussionist drum: see commands.hpp.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "app/commands.hpp"
#include "core/modal/decay.hpp"
#include "core/modal/drum_set.hpp"
#include "core/modal/mode_file.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

struct DrumOptions {
    std::string name;
    std::string output;
    std::size_t modes = 240;
    std::string strokes;
    std::vector<double> positions{0, 0.2, 0.4, 0.6, 0.8, 0.95};
    double noise = 30.0;
    double seconds = 1.5;
};

constexpr int kRate = 48000;
constexpr double kBefore = 0.05;  // [s]

double weight_at(const modal::GivenModes& given, const modal::GivenMode& mode, double place) {
    modal::GivenModes one = given;
    one.modes = {mode};
    std::array<double, 2> values{};
    modal::evaluate_weights(one, {place * given.radius, 0.0, 0.0}, values);
    return values[0];
}

/// What a microphone hears of an impulse at a place, in noise so many dB below the first half
/// second.
std::vector<double> stroke(const modal::GivenModes& given, double place, const DrumOptions& options,
                           std::mt19937& random) {
    const auto start = static_cast<std::size_t>(kBefore * kRate);
    std::vector<double> sound(start + static_cast<std::size_t>(options.seconds * kRate), 0.0);
    for (const auto& mode : given.modes) {
        const double amplitude = weight_at(given, mode, place) * mode.heard;
        const double loss = modal::loss_of_t60(mode.t60);
        for (std::size_t n = start; n < sound.size(); ++n) {
            const double t = static_cast<double>(n - start) / kRate;
            sound[n] += amplitude * std::exp(-loss * t) *
                        std::cos(2 * std::numbers::pi * mode.frequency * t);
        }
    }
    double power = 0.0;
    const std::size_t end = std::min(sound.size(), start + kRate / 2);
    for (std::size_t n = start; n < end; ++n) {
        power += sound[n] * sound[n] / static_cast<double>(end - start);
    }
    std::normal_distribution<double> normal(0.0,
                                            std::sqrt(power) * std::pow(10, -options.noise / 20));
    for (double& sample : sound) {
        sample += normal(random);
    }
    return sound;
}

void write_strokes(const modal::GivenModes& given, const DrumOptions& options) {
    std::mt19937 random(1);
    std::vector<std::vector<double>> sounds;
    double most = 1e-300;
    for (const double place : options.positions) {
        sounds.push_back(stroke(given, place, options, random));
        for (const double sample : sounds.back()) {
            most = std::max(most, std::abs(sample));
        }
    }
    for (std::size_t i = 0; i < sounds.size(); ++i) {
        for (double& sample : sounds[i]) {
            sample *= 0.5 / most;
        }
        files::write_wav(fmt::format("{}{}.wav", options.strokes, i),
                         {.rate = kRate, .channels = 1, .samples = sounds[i]});
    }
}

void run_drum(const DrumOptions& options) {
    const auto given = modal::computed_modes(modal::drum_of_set(options.name), options.modes);
    std::ofstream file(options.output, std::ios::binary);
    file << modal::write_modes(given);
    if (!file.flush()) {
        throw std::runtime_error(options.output + ": cannot be written");
    }
    if (!options.strokes.empty()) {
        write_strokes(given, options);
    }
}

}  // namespace

void add_drum_command(CLI::App& program) {
    auto options = std::make_shared<DrumOptions>();
    auto& o = *options;
    std::string names;
    for (const auto& drum : modal::drum_set()) {
        names += "\n  " + drum.name + ": " + drum.what;
    }
    auto* const command = program.add_subcommand(
        "drum", "Computes the mode file of a drum out of what it is made of");
    command->footer("Drums:" + names);
    command->add_option("name", o.name, "Which drum")->required();
    command->add_option("-o,--output", o.output, "The mode file to write")->required();
    command->add_option("--modes", o.modes, "How many of its lowest modes")
        ->check(CLI::Range(1, 8192));
    command->add_option("--strokes", o.strokes,
                        "Also recordings of strokes, to try 'modes' on: PREFIX0.wav ...");
    command->add_option("--positions", o.positions, "Where they fall: r over radius")
        ->delimiter(',');
    command->add_option("--noise", o.noise,
                        "Noise in them, so far below their first half second [dB]");
    command->callback([options] {
        try {
            run_drum(*options);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(error.what());
        }
    });
}

}  // namespace percussionist::app
