// From a recording to the drums struck in it: the whole way, offline.
//
//     hear -> attacks -> first judgement -> context of the recording -> second judgement -> strokes
//
// Methods and sources: docs/listening.md. Pure functions; they allocate.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/listening/drum_class.hpp"
#include "core/listening/drum_model.hpp"
#include "core/listening/heard.hpp"

namespace percussionist::listening {

struct DrumStroke {
    double time = 0.0;  ///< [s]
    DrumClass drum = DrumClass::kick;
    double velocity = 0.8;    ///< above 0 and up to 1
    double confidence = 1.0;  ///< 0.5 to 1: how sure it is that this was struck
    double pitch = 0.0;       ///< of a tom: the band that it adds most to [Hz]; else 0
};

struct Transcription {
    Heard heard;
    std::vector<DrumStroke> strokes;  ///< in order of time
};

/// Throws std::invalid_argument for a rate that it cannot hear at or
/// samples that are no numbers. progress(share done) is called now and then.
Transcription transcribe(const Playback& playback, double rate, const DrumModel& model,
                         const std::function<void(double)>& progress = {});
/// Of what is in memory: mono, full scale being 1.
Transcription transcribe(std::span<const double> signal, double rate, const DrumModel& model,
                         const std::function<void(double)>& progress = {});

}  // namespace percussionist::listening
