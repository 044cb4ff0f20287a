// What the classifier is told of an attack: levels before and after it, against what is usual.
//
// Frames are taken at fixed distances from that where the rise is steepest: a few before, which
// tell what was sounding already, some within 50 ms after, and, where the whole recording is
// known, some until 200 ms, which tell a cymbal that rings from one that is closed.
//
// Pure; does not allocate or throw.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/listening/band_analyser.hpp"
#include "core/listening/hearing.hpp"

namespace percussionist::listening {

/// Frames of the long window, from the attack's; live listening has the first of them only.
constexpr std::array<int, 13> kLongSteps = {-10, -4, 0, 2, 4, 5, 6, 7, 9, 13, 19, 28, 40};
constexpr std::size_t kLiveLongSteps = 9;
constexpr std::array<int, 10> kQuickSteps = {-4, -2, -1, 0, 1, 2, 3, 4, 6, 8};
/// The last frame that live listening waits for.
constexpr std::size_t kLiveReach = 9;
constexpr std::size_t kReachBack = 10;

constexpr std::size_t feature_count(std::size_t long_steps) {
    return (long_steps + 1) * (kLevels + kFloors) + kQuickSteps.size() * kQuick;
}
constexpr std::size_t kLiveFeatures = feature_count(kLiveLongSteps);
constexpr std::size_t kFeatures = feature_count(kLongSteps.size());

/// Of the attack at frames[at], into `features`: kLiveFeatures or kFeatures of them. Beyond the
/// ends of the frames the first and the last one hold.
void stroke_features(std::span<const BandFrame> frames, std::size_t at, const Hearing& hearing,
                     std::span<float> features) noexcept;

}  // namespace percussionist::listening
