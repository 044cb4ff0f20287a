#include "core/listening/novelty.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::listening {

namespace {

constexpr float kBelowUsual = 2.0F;     ///< the mean, still heard [nats]
constexpr float kBelowLoudest = 14.0F;  ///< a usual loud moment, still heard [nats]
constexpr float kSilence = -100.0F;     ///< [nats]
constexpr float kMost = 5.0F;           ///< a band may rise [nats]
constexpr std::size_t kReach = 5;       ///< of a peak [frames]

struct Group {
    std::size_t first, end;
};
constexpr std::array<Group, 4> kGroups = {Group{0, 2}, Group{2, 5}, Group{5, 8}, Group{0, 8}};

}  // namespace

void Novelty::reset() noexcept {
    for (auto& frame : past_) frame.fill(kSilence);
    count_ = 0;
}

float Novelty::push(const BandFrame& frame, const Hearing& hearing) noexcept {
    std::array<float, kQuick> rise{};
    std::array<float, kQuick>& now = past_[count_ % kKept];
    for (std::size_t b = 0; b < kQuick; ++b) {
        const float least =
            std::max(hearing.mean.quick[b] - kBelowUsual, hearing.loud - kBelowLoudest);
        now[b] = std::max(frame.quick[b], least);
        float before = least;
        for (std::size_t back = 2; back < kKept; ++back) {
            before = std::max(before, past_[(count_ + kKept - back) % kKept][b]);
        }
        rise[b] = std::clamp(now[b] - before, 0.0F, kMost);
    }
    ++count_;
    float most = 0.0F;
    for (const Group& group : kGroups) {
        float sum = 0.0F;
        for (std::size_t b = group.first; b < group.end; ++b) sum += rise[b];
        most = std::max(most, sum / static_cast<float>(group.end - group.first));
    }
    return most;
}

float peak_between(float before, float at, float after) noexcept {
    const float bend = before - 2.0F * at + after;
    return bend < -1e-6F ? std::clamp(0.5F * (before - after) / bend, -0.5F, 0.5F) : 0.0F;
}

std::vector<Attack> attacks(std::span<const float> novelty) {
    std::vector<Attack> found;
    for (std::size_t f = 0; f < novelty.size(); ++f) {
        const float here = novelty[f];
        if (here < Novelty::kThreshold) continue;
        const std::size_t first = f - std::min(f, kReach);
        const std::size_t last = std::min(f + kReach, novelty.size() - 1);
        bool highest = true;
        for (std::size_t g = first; g <= last && highest; ++g) {
            highest = g < f ? novelty[g] < here : novelty[g] <= here;
        }
        if (!highest) continue;
        const float before = f > 0 ? novelty[f - 1] : 0.0F;
        const float after = f + 1 < novelty.size() ? novelty[f + 1] : 0.0F;
        found.push_back({f, peak_between(before, here, after), here});
    }
    return found;
}

}  // namespace percussionist::listening
