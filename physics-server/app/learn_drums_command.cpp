#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "app/commands.hpp"
#include "app/progress.hpp"
#include "core/listening/practice/learning.hpp"
#include "files/spectrogram_picture.hpp"
#include "files/text_file.hpp"

namespace percussionist::app {

namespace {

using namespace listening::practice;

struct LearnDrumsOptions {
    std::filesystem::path output;
    std::size_t pieces = 1300;
    double seconds = 12.0;
    LearningOptions learning;
};

/// Pieces have a seed each, so that it does not matter who makes which.
std::vector<Lesson> practise(const LearnDrumsOptions& options) {
    std::vector<Lesson> lessons(options.pieces);
    std::atomic<std::size_t> next = 0;
    Progress progress("practice pieces");
    const auto work = [&](bool tells) {
        for (std::size_t i = next++; i < lessons.size(); i = next++) {
            lessons[i] =
                lesson(piece_of_music(options.learning.seed * 1'000'000 + i, options.seconds));
            if (tells) progress.tell(static_cast<double>(i) / static_cast<double>(lessons.size()));
        }
    };
    {
        std::vector<std::jthread> helpers;
        for (unsigned n = 1; n < std::thread::hardware_concurrency(); ++n)
            helpers.emplace_back(work, false);
        work(true);
    }
    progress.done();
    return lessons;
}

void learn_drums(const LearnDrumsOptions& options) {
    const std::vector<Lesson> lessons = practise(options);
    Progress progress("learning");
    const listening::DrumModel model =
        learn(lessons, options.learning,
              [&](double done, const char* what) { progress.tell(done, what); });
    progress.done();
    const std::string text = listening::to_text(model);
    files::write_text(options.output, text);
    fmt::print("learnt from {} pieces of {} s: {} bytes in {}\n", options.pieces, options.seconds,
               text.size(), options.output.string());
}

}  // namespace

void add_learn_drums_command(CLI::App& program) {
    auto options = std::make_shared<LearnDrumsOptions>();
    CLI::App& command = *program.add_subcommand(
        "learn-drums",
        "learn to tell drums apart, from pieces that the program makes up and plays to itself");
    command
        .add_option("-o,--output", options->output,
                    "what was learnt, as transcribe --model takes it")
        ->required();
    command.add_option("--pieces", options->pieces, "to practise on")
        ->check(CLI::Range(20, 100000))
        ->capture_default_str();
    command.add_option("--seconds", options->seconds, "length of a piece")
        ->check(CLI::Range(4.0, 120.0))
        ->capture_default_str();
    command.add_option("--epochs", options->learning.epochs, "times each is gone through")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.add_option("--seed", options->learning.seed, "another one, other pieces")
        ->capture_default_str();
    command.callback([options] { learn_drums(*options); });
}

}  // namespace percussionist::app
