#include "core/listening/stroke_strength.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::listening {

namespace {

struct Bands {
    std::size_t first, end;
};

constexpr std::size_t kReach = 9;     ///< after the attack [frames]
constexpr std::size_t kBefore = 3;    ///< before it [frames]
constexpr Bands kTomBands = {4, 14};  ///< 65 to 480 Hz
constexpr double kSpan = 6.9;         ///< of velocity from 0 to 1: 30 dB [nats]
constexpr double kLoudVelocity = 0.9;
constexpr double kSoftest = 0.1;

Bands bands_of(DrumClass drum) noexcept {
    switch (drum) {
        case DrumClass::kick:
            return {0, 10};
        case DrumClass::snare:
            return {8, 28};
        case DrumClass::tom:
            return kTomBands;
        case DrumClass::closed_hat:
        case DrumClass::open_hat:
            return {24, kLevels};
        default:
            return {16, kLevels};
    }
}

float power_between(const BandFrame& frame, const Bands& bands) noexcept {
    float sum = 0.0F;
    for (std::size_t b = bands.first; b < bands.end; ++b) sum += std::exp(frame.level[b]);
    return sum;
}

}  // namespace

float added_power(std::span<const BandFrame> frames, std::size_t at, DrumClass drum) noexcept {
    const Bands bands = bands_of(drum);
    const float before = power_between(frames[at - std::min(at, kBefore)], bands);
    float most = before;
    for (std::size_t f = at; f <= std::min(at + kReach, frames.size() - 1); ++f) {
        most = std::max(most, power_between(frames[f], bands));
    }
    return std::log(most - before + 1e-12F);
}

double pitch_of(std::span<const BandFrame> frames, std::size_t at) noexcept {
    const BandFrame& before = frames[at - std::min(at, kBefore)];
    const BandFrame& after = frames[std::min(at + kReach, frames.size() - 1)];
    std::size_t best = kTomBands.first;
    float most = -1.0F;
    for (std::size_t b = kTomBands.first; b < kTomBands.end; ++b) {
        const float added = std::exp(after.level[b]) - std::exp(before.level[b]);
        if (added > most) {
            most = added;
            best = b;
        }
    }
    return level_frequency(best);
}

double velocity_of(float power, float loud) noexcept {
    const double below = static_cast<double>(power - loud) / kSpan;
    return std::clamp(kLoudVelocity + below, kSoftest, 1.0);
}

}  // namespace percussionist::listening
