#include "core/listening/beats.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::listening {

namespace {

constexpr double kStep = 0.005;       ///< of time [s]
constexpr double kShortest = 0.28;    ///< beat [s]
constexpr double kLongest = 1.1;      ///< beat [s]
constexpr double kUsual = 0.52;       ///< beat [s]
constexpr double kOctaves = 0.7;      ///< deviation of beats from the usual one
constexpr double kBlur = 0.015;       ///< of an accent [s]
constexpr double kSteadiness = 60.0;  ///< against accents

/// How much a beat is to be expected where a drum sounds.
double accent(const DrumStroke& stroke) {
    constexpr std::array<double, kDrumClasses> kWeights = {1.0, 1.0, 0.4, 0.5, 0.5, 1.0, 0.4, 0.3};
    return kWeights[index(stroke.drum)] * stroke.velocity * stroke.confidence;
}

std::vector<double> accents(std::span<const DrumStroke> strokes, double duration) {
    std::vector<double> grid(static_cast<std::size_t>(duration / kStep) + 2, 0.0);
    for (const DrumStroke& stroke : strokes) {
        const auto middle = static_cast<std::ptrdiff_t>(std::lround(stroke.time / kStep));
        for (std::ptrdiff_t k = -8; k <= 8; ++k) {
            const std::ptrdiff_t at = middle + k;
            if (at < 0 || at >= static_cast<std::ptrdiff_t>(grid.size())) continue;
            const double away = (static_cast<double>(at) * kStep - stroke.time) / kBlur;
            grid[static_cast<std::size_t>(at)] += accent(stroke) * std::exp(-0.5 * away * away);
        }
    }
    return grid;
}

double repeats(const std::vector<double>& grid, std::size_t lag) {
    if (lag >= grid.size()) return 0.0;
    double sum = 0.0;
    for (std::size_t n = lag; n < grid.size(); ++n) sum += grid[n] * grid[n - lag];
    return sum / static_cast<double>(grid.size() - lag + 400);
}

double beat_length(const std::vector<double>& grid) {
    double best = kUsual, most = 0.0;
    for (auto lag = static_cast<std::size_t>(kShortest / kStep);
         static_cast<double>(lag) * kStep <= kLongest; ++lag) {
        const double octaves = std::log2(static_cast<double>(lag) * kStep / kUsual) / kOctaves;
        const double score = std::exp(-0.5 * octaves * octaves) *
                             (repeats(grid, lag) + repeats(grid, 2 * lag) + repeats(grid, 4 * lag));
        if (score > most) {
            most = score;
            best = static_cast<double>(lag) * kStep;
        }
    }
    return best;
}

std::vector<double> best_path(const std::vector<double>& grid, double beat) {
    const auto near = static_cast<std::size_t>(std::lround(0.6 * beat / kStep));
    const auto far = static_cast<std::size_t>(std::lround(1.6 * beat / kStep));
    std::vector<double> score(grid.size(), 0.0);
    std::vector<std::size_t> from(grid.size(), 0);
    for (std::size_t n = 0; n < grid.size(); ++n) {
        double best = 0.0;
        for (std::size_t lag = near; lag <= std::min(far, n); ++lag) {
            const double bend = std::log(static_cast<double>(lag) * kStep / beat);
            const double path = score[n - lag] - kSteadiness * bend * bend;
            if (path > best) {
                best = path;
                from[n] = n - lag;
            }
        }
        score[n] = grid[n] + best;
    }
    const auto reach = std::min(grid.size(), static_cast<std::size_t>(beat / kStep));
    auto at = static_cast<std::size_t>(
        std::max_element(score.end() - static_cast<std::ptrdiff_t>(reach), score.end()) -
        score.begin());
    std::vector<double> times;
    while (true) {
        times.push_back(static_cast<double>(at) * kStep);
        if (from[at] == 0 || score[from[at]] <= 0.0) break;
        at = from[at];
    }
    std::reverse(times.begin(), times.end());
    return times;
}

/// For each beat how much speaks for a bar's first (what a back beat's snare does not).
std::vector<double> firstness(std::span<const DrumStroke> strokes, const std::vector<double>& beats,
                              double near) {
    std::vector<double> first(beats.size(), 0.0);
    for (const DrumStroke& stroke : strokes) {
        const auto after = std::lower_bound(beats.begin(), beats.end(), stroke.time - near);
        if (after == beats.end() || std::abs(*after - stroke.time) > near) continue;
        double& sum = first[static_cast<std::size_t>(after - beats.begin())];
        if (stroke.drum == DrumClass::kick) sum += stroke.velocity;
        if (stroke.drum == DrumClass::snare) sum -= stroke.velocity;
        if (stroke.drum == DrumClass::crash) sum += 2.0 * stroke.velocity;
    }
    return first;
}

void find_bars(std::span<const DrumStroke> strokes, Beats& beats) {
    const auto first = firstness(strokes, beats.times, 0.15 * beats.seconds_per_beat());
    // What is expected on each beat of a bar.
    const std::array<double, 4> four = {1.0, -0.8, 0.5, -0.8};
    const std::array<double, 3> three = {1.0, -0.4, -0.4};
    double most = -1e9;
    const auto consider = [&](std::span<const double> bar, double handicap) {
        for (std::size_t phase = 0; phase < bar.size(); ++phase) {
            double score = 0.0;
            for (std::size_t b = 0; b < first.size(); ++b)
                score += first[b] * bar[(b + bar.size() - phase) % bar.size()];
            score = handicap * score / static_cast<double>(first.size() + 1);
            if (score > most) {
                most = score;
                beats.per_bar = static_cast<int>(bar.size());
                beats.first_downbeat = phase;
            }
        }
    };
    consider(four, 1.0);
    consider(three, 0.6);
    beats.first_downbeat = std::min(beats.first_downbeat, beats.times.size() - 1);
}

}  // namespace

double Beats::seconds_per_beat() const {
    if (times.size() < 2) return 0.5;
    return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

Beats find_beats(std::span<const DrumStroke> strokes, double duration) {
    Beats beats;
    if (strokes.empty()) return beats;
    const std::vector<double> grid = accents(strokes, std::max(duration, strokes.back().time));
    beats.times = best_path(grid, beat_length(grid));
    find_bars(strokes, beats);
    return beats;
}

}  // namespace percussionist::listening
