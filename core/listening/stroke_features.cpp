#include "core/listening/stroke_features.hpp"

#include <algorithm>

namespace percussionist::listening {

namespace {

constexpr float kLeast = -5.0F;  ///< what is below its band's mean, at most [nats]
constexpr float kMost = 6.0F;
constexpr float kFaintest = -16.0F;  ///< a band's mean below loud moments [nats]

class Filler {
  public:
    explicit Filler(std::span<float> to) : to_(to) {}

    template <std::size_t N>
    void against(const std::array<float, N>& level, const std::array<float, N>& mean) noexcept {
        for (std::size_t b = 0; b < N; ++b) {
            to_[count_++] = std::clamp(level[b] - mean[b], kLeast, kMost);
        }
    }
    template <std::size_t N>
    void colour(const std::array<float, N>& mean, float loud) noexcept {
        for (const float level : mean) to_[count_++] = std::max(level - loud, kFaintest);
    }

  private:
    std::span<float> to_;
    std::size_t count_ = 0;
};

}  // namespace

void stroke_features(std::span<const BandFrame> frames, std::size_t at, const Hearing& hearing,
                     std::span<float> features) noexcept {
    const auto frame = [&](int step) -> const BandFrame& {
        const auto wanted = static_cast<std::ptrdiff_t>(at) + step;
        const auto last = static_cast<std::ptrdiff_t>(frames.size()) - 1;
        return frames[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(wanted, 0, last))];
    };
    Filler filler(features);
    filler.colour(hearing.mean.level, hearing.loud);
    filler.colour(hearing.mean.floor, hearing.loud);
    for (const int step : kQuickSteps) filler.against(frame(step).quick, hearing.mean.quick);
    const bool live = features.size() < kFeatures;
    const std::span<const int> steps =
        std::span(kLongSteps).first(live ? kLiveLongSteps : kLongSteps.size());
    for (const int step : steps) {
        filler.against(frame(step).level, hearing.mean.level);
        filler.against(frame(step).floor, hearing.mean.floor);
    }
}

}  // namespace percussionist::listening
