// A whole recording as listening sees it: frames, what is usual in them, and the attacks.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/listening/band_analyser.hpp"
#include "core/listening/hearing.hpp"
#include "core/listening/novelty.hpp"

namespace percussionist::listening {

struct Heard {
    double rate = 44100.0;  ///< [Hz]
    double duration = 0.0;  ///< [s]
    std::size_t hop = 220;  ///< samples from frame to frame
    std::vector<BandFrame> frames;
    Hearing hearing;
    std::vector<float> novelty;  ///< of each frame
    std::vector<Attack> attacks;
};

/// Plays a whole recording, mono, full scale being 1, to the one who takes its pieces; from the
/// beginning each time it is called. So a recording need not fit in memory.
using Playback = std::function<void(const std::function<void(std::span<const double>)>& take)>;
/// Of what is in memory; it has to stay there.
Playback playback_of(std::span<const double> signal);

/// Throws std::invalid_argument for a rate that it cannot hear at and for samples that are no
/// numbers. progress(share done) is called now and then.
Heard hear(const Playback& playback, double rate, const std::function<void(double)>& progress = {});

/// Seconds from the first sample to where a listener puts the stroke whose rise is around a frame.
double time_of(double frame, std::size_t hop, double rate);

}  // namespace percussionist::listening
