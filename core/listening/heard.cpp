#include "core/listening/heard.hpp"

#include <algorithm>

namespace percussionist::listening {

namespace {

/// From a stroke's first sound to the end of the frame that rises most, measured [s].
constexpr double kFromOnset = 0.0075;
constexpr std::size_t kTold = 2000;  ///< frames between reports of progress

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
    for (std::size_t f = 0; f < count; ++f) {
        const std::size_t from = std::min(f * heard.hop, signal.size());
        const std::size_t size = std::min(heard.hop, signal.size() - from);
        std::copy_n(signal.begin() + static_cast<std::ptrdiff_t>(from), size, block.begin());
        std::fill(block.begin() + static_cast<std::ptrdiff_t>(size), block.end(), 0.0);
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
