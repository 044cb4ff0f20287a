#include "core/listening/hearing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace percussionist::listening {

namespace {

constexpr float kSilent = 14.0F;           ///< below loud moments is silence [nats]
constexpr float kNothing = -24.0F;         ///< of which nothing is learnt [nats]
constexpr float kBeforeAnything = -14.0F;  ///< what is usual before anything was heard [nats]
constexpr double kMemory = 1600.0;         ///< [frames]
constexpr float kUp = 0.06F, kDown = 0.003F, kTowards = 0.1F;  ///< of what is loud, a frame
constexpr double kLoudPart = 0.95;                             ///< of all moments are less loud

template <std::size_t N>
void approach(std::array<float, N>& mean, const std::array<float, N>& value, float share) noexcept {
    for (std::size_t b = 0; b < N; ++b) mean[b] += share * (value[b] - mean[b]);
}

void approach(BandFrame& mean, const BandFrame& value, float share) noexcept {
    approach(mean.level, value.level, share);
    approach(mean.floor, value.floor, share);
    approach(mean.quick, value.quick, share);
}

}  // namespace

float loudness(const BandFrame& frame) noexcept {
    float sum = 1e-12F;
    for (const float level : frame.quick) sum += std::exp(level);
    return std::log(sum);
}

Hearing hearing_of(std::span<const BandFrame> frames) {
    Hearing hearing;
    std::vector<float> levels;
    for (const BandFrame& frame : frames) levels.push_back(loudness(frame));
    if (levels.empty()) return hearing;
    std::vector<float> sorted = levels;
    const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(
                                          kLoudPart * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), nth, sorted.end());
    hearing.loud = std::max(*nth, kNothing);
    float count = 0.0F;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (levels[f] > hearing.loud - kSilent) approach(hearing.mean, frames[f], 1.0F / ++count);
    }
    return hearing;
}

RunningHearing::RunningHearing() {
    hearing_.mean.level.fill(kBeforeAnything);
    hearing_.mean.floor.fill(kBeforeAnything);
    hearing_.mean.quick.fill(kBeforeAnything);
}

void RunningHearing::push(const BandFrame& frame) noexcept {
    const float level = loudness(frame);
    if (level < std::max(hearing_.loud - kSilent, kNothing)) {
        hearing_.loud -= kDown;
        return;
    }
    weight_ = std::min(weight_ + 1.0, kMemory);
    if (weight_ == 1.0) hearing_.loud = level;
    const auto share = static_cast<float>(1.0 / weight_);
    approach(hearing_.mean, frame, share);
    // A quantile: far up when above, a little down when below.
    const float up = level - hearing_.loud;
    hearing_.loud += up > 0.0F ? kUp + kTowards * up : -kDown;
}

}  // namespace percussionist::listening
