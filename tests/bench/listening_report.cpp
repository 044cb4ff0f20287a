// How well drums are told from recordings with annotations: F-measure at 50 ms for each class and
// file, errors of onsets, speed.
//
//     listening_report FOLDER [MODEL]
//
// FOLDER holds NAME.class.txt (a time in seconds and a class a line: KD SD HH TT CY OT),
// NAME-drums.wav and NAME.wav, either of which may be missing. MODEL is what learn-drums wrote.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "core/listening/live_listener.hpp"
#include "core/listening/median.hpp"
#include "core/listening/transcription.hpp"
#include "files/wav_file.hpp"

using namespace percussionist;

namespace {

using Times = std::map<std::string, std::vector<double>>;

constexpr std::array<const char*, 5> kClasses = {"KD", "SD", "HH", "TT", "CY"};
constexpr std::size_t kMain = 3;     ///< of them count in the mean
constexpr double kTolerance = 0.05;  ///< [s]

/// Of this program, whatever else runs beside it [s].
double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Count {
    int right = 0, wrong = 0, missed = 0;
    void operator+=(const Count& other) {
        right += other.right;
        wrong += other.wrong;
        missed += other.missed;
    }
    [[nodiscard]] bool any() const { return right + missed > 0; }
    [[nodiscard]] double f() const {
        return right == 0 ? 0.0 : 2.0 * right / (2.0 * right + wrong + missed);
    }
};

const char* annotated_as(listening::DrumClass drum) {
    using listening::DrumClass;
    switch (drum) {
        case DrumClass::kick:
            return "KD";
        case DrumClass::snare:
            return "SD";
        case DrumClass::closed_hat:
        case DrumClass::open_hat:
            return "HH";
        case DrumClass::tom:
            return "TT";
        case DrumClass::crash:
        case DrumClass::ride:
            return "CY";
        default:
            return "OT";
    }
}

Times read_annotations(const std::filesystem::path& path) {
    Times times;
    std::ifstream file(path);
    double time = 0.0;
    std::string name;
    while (file >> time >> name) times[name].push_back(time);
    return times;
}

/// Pairs in order of time; errors are those of the pairs [s].
Count compare(std::vector<double> expected, std::vector<double> found,
              std::vector<double>& errors) {
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    Count count;
    std::size_t e = 0, f = 0;
    while (e < expected.size() && f < found.size()) {
        const double error = found[f] - expected[e];
        if (std::abs(error) <= kTolerance) {
            errors.push_back(error);
            ++count.right, ++e, ++f;
        } else if (error > 0.0) {
            ++count.missed, ++e;
        } else {
            ++count.wrong, ++f;
        }
    }
    count.missed += static_cast<int>(expected.size() - e);
    count.wrong += static_cast<int>(found.size() - f);
    return count;
}

class Report {
  public:
    explicit Report(listening::DrumModel model) : model_(std::move(model)) {
        std::puts(
            "| recording | KD | SD | HH | mean | TT | CY | onset error ms | within 10 ms | x real "
            "time |\n"
            "|---|---|---|---|---|---|---|---|---|---|");
    }

    void recording(const std::filesystem::path& path, const Times& expected) {
        const files::Audio audio = files::read_audio(path);
        const auto signal = files::mono(audio);
        const double start = processor_time();
        const auto made = listening::transcribe(signal, audio.rate, model_);
        const double took = processor_time() - start;
        Times found;
        for (const auto& stroke : made.strokes)
            found[annotated_as(stroke.drum)].push_back(stroke.time);
        std::array<Count, kClasses.size()> counts;
        std::vector<double> errors;
        for (std::size_t c = 0; c < kClasses.size(); ++c) {
            const auto of = [&](Times times) { return times[kClasses[c]]; };
            counts[c] = compare(of(expected), of(found), errors);
        }
        add(counts, errors);
        const double speed = static_cast<double>(signal.size()) / audio.rate / took;
        line(path.filename().string(), counts, errors, speed);
    }

    void total(const char* what) {
        line(what, pooled_, errors_, 0.0);
        if (files_ > 0)
            std::printf("| mean of the %d files' means | | | | %.3f | | | | | |\n", files_,
                        sum_ / files_);
        pooled_ = {};
        errors_.clear();
        files_ = 0;
        sum_ = 0.0;
    }

  private:
    using Counts = std::array<Count, kClasses.size()>;

    static double mean(const Counts& counts) {
        double sum = 0.0;
        int classes = 0;
        for (std::size_t c = 0; c < kMain; ++c) {
            if (!counts[c].any()) continue;
            sum += counts[c].f();
            ++classes;
        }
        return classes == 0 ? 0.0 : sum / classes;
    }

    void add(const Counts& counts, const std::vector<double>& errors) {
        for (std::size_t c = 0; c < counts.size(); ++c) pooled_[c] += counts[c];
        errors_.insert(errors_.end(), errors.begin(), errors.end());
        sum_ += mean(counts);
        ++files_;
    }

    static std::string cell(const Count& count) {
        char text[64];
        if (!count.any()) {
            std::snprintf(text, sizeof text, "none (%d)", count.wrong);
        } else {
            std::snprintf(text, sizeof text, "%.3f (%d %d %d)", count.f(), count.right, count.wrong,
                          count.missed);
        }
        return text;
    }

    static void line(const std::string& name, const Counts& counts,
                     const std::vector<double>& errors, double speed) {
        std::vector<double> sizes;
        std::size_t near = 0;
        for (const double error : errors) {
            sizes.push_back(std::abs(error));
            near += std::abs(error) <= 0.01 ? 1 : 0;
        }
        std::printf("| %s | %s | %s | %s | %.3f | %s | %s | %.1f (median %+.1f) | %.0f %% |",
                    name.c_str(), cell(counts[0]).c_str(), cell(counts[1]).c_str(),
                    cell(counts[2]).c_str(), mean(counts), cell(counts[3]).c_str(),
                    cell(counts[4]).c_str(), 1e3 * listening::median(sizes),
                    1e3 * listening::median(errors),
                    errors.empty()
                        ? 0.0
                        : 100.0 * static_cast<double>(near) / static_cast<double>(errors.size()));
        if (speed > 0.0) std::printf(" %.0f", speed);
        std::puts(" |");
    }

    listening::DrumModel model_;
    Counts pooled_;
    std::vector<double> errors_;
    double sum_ = 0.0;
    int files_ = 0;
};

/// How much of a core live listening takes, in blocks of 64 samples, and its longest block.
void report_live(const std::filesystem::path& path, const listening::DrumModel& model) {
    using Clock = std::chrono::steady_clock;
    const files::Audio audio = files::read_audio(path);
    const auto signal = files::mono(audio);
    const std::vector<float> samples(signal.begin(), signal.end());
    listening::LiveListener listener({.rate = static_cast<double>(audio.rate)}, model);
    std::chrono::duration<double> longest{};
    const double began = processor_time();
    for (std::size_t n = 0; n + 64 <= samples.size(); n += 64) {
        const auto start = Clock::now();
        listener.process({samples.data() + n, 64}, [](const auto&, std::size_t) {});
        const std::chrono::duration<double> took = Clock::now() - start;
        longest = std::max(longest, took);
    }
    const double duration = static_cast<double>(signal.size()) / audio.rate;
    std::printf("\nlive, %s: %.2f %% of a core, longest block %.2f ms\n",
                path.filename().string().c_str(), 100.0 * (processor_time() - began) / duration,
                1e3 * longest.count());
}

std::vector<std::filesystem::path> annotations_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().string().ends_with(".class.txt")) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

listening::DrumModel model_from(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return listening::model_from_text(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("listening_report FOLDER [MODEL]\n", stderr);
        return 2;
    }
    try {
        const listening::DrumModel model =
            argc > 2 ? model_from(argv[2]) : listening::learnt_drums();
        Report report(model);
        std::filesystem::path last;
        for (const char* kind : {"-drums.wav", ".wav"}) {
            for (const auto& path : annotations_in(argv[1])) {
                const std::string name = path.string();
                const std::filesystem::path sound = name.substr(0, name.size() - 10) + kind;
                if (!std::filesystem::exists(sound)) continue;
                report.recording(sound, read_annotations(path));
                last = sound;
            }
            report.total(kind == std::string("-drums.wav") ? "drums alone, all"
                                                           : "full mixes, all");
        }
        if (!last.empty()) report_live(last, model);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "listening_report: %s\n", error.what());
        return 1;
    }
}
