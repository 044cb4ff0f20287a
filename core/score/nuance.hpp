// How a stroke is played, in the words of timpanists.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace percussionist::score {

enum class Nuance { legato, tenuto, accent, vertical_accent, staccato, piston };

inline constexpr std::array<std::string_view, 6> kNuanceNames{
    "legato", "tenuto", "accent", "vertical-accent", "staccato", "piston"};

constexpr std::string_view name(Nuance nuance) {
    return kNuanceNames[static_cast<std::size_t>(nuance)];
}

constexpr std::optional<Nuance> nuance_of(std::string_view name) {
    for (std::size_t i = 0; i < kNuanceNames.size(); ++i) {
        if (kNuanceNames[i] == name) return static_cast<Nuance>(i);
    }
    return std::nullopt;
}

/// How fast the stick strikes against a legato stroke of the same dynamic: medians of timpanists'
/// strokes (1.9, 2.8, 2.8, 4.4, 0.9 and 4.4 m/s).
constexpr double impact_ratio(Nuance nuance) {
    constexpr std::array<double, 6> kSpeeds{1.9, 2.8, 2.8, 4.4, 0.9, 4.4};
    return kSpeeds[static_cast<std::size_t>(nuance)] / kSpeeds[0];
}

}  // namespace percussionist::score
