#include "core/listening/heard.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::listening {

namespace {

/// From where listeners put a stroke, some 4 ms after its first sound, to the end of the frame that
/// rises most; measured on recordings [s].
constexpr double kFromOnset = 0.0035;
constexpr double kUsualLevel = 0.1;  ///< to which recordings are brought: of the practice pieces
constexpr double kMostGain = 100.0;
constexpr std::size_t kTold = 2000;  ///< frames between reports of progress

/// What brings a recording to the usual root mean square; not all the way for next to nothing.
double gain_for(std::span<const double> signal) {
    double sum = 0.0;
    for (const double x : signal) sum += x * x;
    if (sum == 0.0) return 1.0;
    const double level = std::sqrt(sum / static_cast<double>(signal.size()));
    return std::min(kUsualLevel / level, kMostGain);
}

}  // namespace

double time_of(double frame, std::size_t hop, double rate) {
    return std::max(0.0, (frame + 1.0) * static_cast<double>(hop) / rate - kFromOnset);
}

Heard hear(std::span<const double> signal, double rate,
           const std::function<void(double)>& progress) {
    BandAnalyser analyser(rate);
    Heard heard{.rate = rate,
                .hop = analyser.hop(),
                .frames = {},
                .hearing = {},
                .novelty = {},
                .attacks = {}};
    const std::size_t count = (signal.size() + heard.hop - 1) / heard.hop + 1;
    heard.frames.resize(count);
    std::vector<double> block(heard.hop);
    const double gain = gain_for(signal);
    for (std::size_t f = 0; f < count; ++f) {
        const std::size_t from = std::min(f * heard.hop, signal.size());
        const std::size_t size = std::min(heard.hop, signal.size() - from);
        std::copy_n(signal.begin() + static_cast<std::ptrdiff_t>(from), size, block.begin());
        std::fill(block.begin() + static_cast<std::ptrdiff_t>(size), block.end(), 0.0);
        for (double& x : block) x *= gain;
        analyser.process(block, heard.frames[f]);
        if (progress && f % kTold == 0)
            progress(static_cast<double>(f) / static_cast<double>(count));
    }
    heard.hearing = hearing_of(heard.frames);
    Novelty novelty;
    for (const BandFrame& frame : heard.frames)
        heard.novelty.push_back(novelty.push(frame, heard.hearing));
    heard.attacks = attacks(heard.novelty);
    return heard;
}

}  // namespace percussionist::listening
