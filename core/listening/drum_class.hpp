// The drums that listening tells apart.
//
// General MIDI has a key for each; foot and stick on a closed hat are one class, and so are toms of
// any size (their size is heard afterwards, as a pitch).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace percussionist::listening {

enum class DrumClass { kick, snare, closed_hat, open_hat, tom, crash, ride, other };

constexpr std::size_t kDrumClasses = 8;

constexpr std::array<std::string_view, kDrumClasses> kDrumNames = {
    "kick", "snare", "closed-hat", "open-hat", "tom", "crash", "ride", "other"};

constexpr std::size_t index(DrumClass drum) {
    return static_cast<std::size_t>(drum);
}
constexpr std::string_view name(DrumClass drum) {
    return kDrumNames[index(drum)];
}

}  // namespace percussionist::listening
