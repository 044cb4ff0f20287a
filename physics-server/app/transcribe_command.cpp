#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/drum_midi.hpp"
#include "app/progress.hpp"
#include "core/listening/beats.hpp"
#include "core/listening/transcription.hpp"
#include "files/midi_writer.hpp"
#include "files/spectrogram_picture.hpp"
#include "files/text_file.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

struct TranscribeOptions {
    std::filesystem::path recording, midi, csv, plot, model;
};

listening::DrumModel model_of(const std::filesystem::path& path) {
    if (path.empty()) return listening::learnt_drums();
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path.string() + ": cannot be opened");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    return listening::model_from_text(text);
}

std::string counts(const listening::Transcription& made) {
    std::array<std::size_t, listening::kDrumClasses> each{};
    for (const auto& stroke : made.strokes) ++each[listening::index(stroke.drum)];
    std::string text;
    for (std::size_t c = 0; c < each.size(); ++c) {
        if (each[c] > 0)
            text +=
                fmt::format("{}{} {}", text.empty() ? "" : ", ", each[c], listening::kDrumNames[c]);
    }
    return text.empty() ? "nothing that sounds like a drum" : text;
}

void transcribe(TranscribeOptions options) {
    if (options.midi.empty())
        options.midi = std::filesystem::path(options.recording).replace_extension(".mid");
    if (options.csv.empty())
        options.csv = std::filesystem::path(options.midi).replace_extension(".csv");
    const listening::DrumModel model = model_of(options.model);
    const double rate = files::rate_of(options.recording);
    const auto playback = [&](const auto& take) { files::play_mono(options.recording, take); };
    const std::string name = options.recording.filename().string();
    Progress progress("listening to " + name);
    const listening::Transcription made = [&] {
        try {
            return listening::transcribe(playback, rate, model, progress.teller());
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(options.recording.string() + ": " + error.what());
        }
    }();
    progress.done();
    const double duration = made.heard.duration;
    const listening::Beats beats = listening::find_beats(made.strokes, duration);
    files::write_midi_file(options.midi, to_midi(made, beats, name));
    files::write_text(options.csv, to_csv(made));
    fmt::print("{}: {:.1f} s: {}\n", name, duration, counts(made));
    if (!beats.times.empty()) {
        fmt::print("tempo: {:.1f} beats a minute, {} to a bar\n", 60.0 / beats.seconds_per_beat(),
                   beats.per_bar);
    }
    fmt::print("written: {}, {}\n", options.midi.string(), options.csv.string());
    if (!options.plot.empty()) {
        files::write_text(options.plot, files::spectrogram_svg(made, beats, name));
        fmt::print("written: {}\n", options.plot.string());
    }
}

}  // namespace

void add_transcribe_command(CLI::App& program) {
    auto options = std::make_shared<TranscribeOptions>();
    CLI::App& command = *program.add_subcommand(
        "transcribe", "hear which drums are struck when in a recording, and write it as MIDI");
    command
        .add_option("recording", options->recording,
                    "WAV, FLAC, OGG, AIFF; any rate from 8 kHz, any channels")
        ->required();
    command.add_option("-o,--output", options->midi, "the MIDI file; else beside the recording");
    command.add_option("--csv", options->csv,
                       "times, drums, velocities, confidences; else beside the MIDI file");
    command.add_option("--plot", options->plot,
                       "a picture (SVG): spectrogram, strokes, classes, beats");
    command.add_option("--model", options->model,
                       "what learn-drums wrote, instead of what comes with the program");
    command.callback([options] { transcribe(*options); });
}

}  // namespace percussionist::app
