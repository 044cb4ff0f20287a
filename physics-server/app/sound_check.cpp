#include "app/sound_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "app/performance_log.hpp"
#include "core/listening/median.hpp"
#include "core/listening/onset.hpp"
#include "files/wav_file.hpp"

namespace percussionist::app {

namespace {

/// Two onsets so near agree [s].
constexpr double kAgree = 0.004;
/// How far an onset is looked for around its time [s].
constexpr double kWindow = 0.008;
/// Of strokes closer than this the louder covers the other [s].
constexpr double kAlone = 0.03;
/// The offset is found from so many strokes and onsets of the beginning.
constexpr std::size_t kFirst = 60;

int agreeing(std::span<const double> asked, std::span<const double> heard, double offset) {
    int count = 0;
    for (const double time : asked) {
        const auto next = std::lower_bound(heard.begin(), heard.end(), time + offset - kAgree);
        if (next != heard.end() && *next < time + offset + kAgree) ++count;
    }
    return count;
}

/// The offset with which most strokes have an onset.
double coarse_offset(std::span<const double> asked, std::span<const double> heard) {
    const auto some = [](std::span<const double> all) {
        return all.first(std::min(all.size(), kFirst));
    };
    int best = 0;
    double offset = 0.0;
    for (const double time : some(asked)) {
        for (const double onset : some(heard)) {
            const int count = agreeing(some(asked), heard, onset - time);
            if (count > best) {
                best = count;
                offset = onset - time;
            }
        }
    }
    return offset;
}

/// Those with no other within kAlone.
std::vector<double> alone(std::span<const double> times) {
    std::vector<double> all;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const bool after = i == 0 || times[i] - times[i - 1] > kAlone;
        const bool before = i + 1 == times.size() || times[i + 1] - times[i] > kAlone;
        if (after && before) all.push_back(times[i]);
    }
    return all;
}

}  // namespace

SoundCheck check_sound(const std::filesystem::path& recording,
                       const std::filesystem::path& contacts_csv) {
    const files::Audio audio = files::read_audio(recording);
    const std::vector<double> sound = files::mono(audio);
    const std::vector<double> asked = read_asked_times(contacts_csv);

    SoundCheck check;
    check.strokes = static_cast<int>(asked.size());
    for (const double sample : audio.samples) {
        check.finite = check.finite && std::isfinite(sample);
        check.peak = std::max(check.peak, std::abs(sample));
    }
    if (!check.finite) return check;

    std::vector<double> heard;
    for (const listening::Onset& onset : listening::find_onsets(sound, audio.rate)) {
        heard.push_back(onset.time);
    }
    const double coarse = coarse_offset(asked, heard);
    std::vector<double> times = alone(asked);
    for (double& time : times) time += coarse;
    check.alone = static_cast<int>(times.size());
    std::vector<double> errors;
    const auto onsets = listening::onsets_near(sound, audio.rate, times, kWindow);
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (onsets[i]) errors.push_back(*onsets[i] - times[i]);
    }
    const double fine = listening::median(errors);
    check.heard = static_cast<int>(errors.size());
    check.offset = coarse + fine;
    for (double& error : errors) {
        error = std::abs(error - fine);
        check.worst_error = std::max(check.worst_error, error);
    }
    check.median_error = listening::median(errors);
    return check;
}

std::string describe(const SoundCheck& check) {
    if (!check.finite) return "the recording has samples that are no numbers\n";
    return fmt::format(
        "strokes heard      {} of {} (of {}; the others are too close together to tell apart)\n"
        "sound timing       median {:.3f} ms, worst {:.3f} ms (after a constant {:+.3f} ms)\n"
        "peak level         {:.3f} ({:.1f} dB)\n",
        check.heard, check.alone, check.strokes, 1e3 * check.median_error, 1e3 * check.worst_error,
        1e3 * check.offset, check.peak, 20.0 * std::log10(std::max(check.peak, 1e-9)));
}

}  // namespace percussionist::app
