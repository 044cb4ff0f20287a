// The settings that a FASTRAK has for each station: letter, numbers, units. For the simulated unit.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace percussionist::tracker {

/// A setting of one station: its letter, how many numbers, of what width it tells them, their unit.
struct Setting {
    enum class Unit { kLength, kAngle, kNone };
    char letter;
    std::size_t count;
    int width;
    double most;  // of the unit's own units
    Unit unit;
};

inline constexpr std::array kSettings = {
    Setting{'A', 9, 7, 999, Setting::Unit::kLength},
    Setting{'G', 3, 7, 180, Setting::Unit::kAngle},
    Setting{'H', 3, 7, 999, Setting::Unit::kNone},
    Setting{'I', 1, 7, 999, Setting::Unit::kLength},
    Setting{'N', 3, 7, 999, Setting::Unit::kLength},
    Setting{'r', 3, 8, 180, Setting::Unit::kAngle},
    Setting{'Q', 6, 7, 180, Setting::Unit::kAngle},
    Setting{'V', 6, 7, 999, Setting::Unit::kLength},
};

inline const Setting* find_setting(char letter) {
    for (const Setting& setting : kSettings) {
        if (setting.letter == letter) {
            return &setting;
        }
    }
    return nullptr;
}

inline double unit_of(const Setting& setting, bool centimetres) {
    switch (setting.unit) {
        case Setting::Unit::kLength:
            return centimetres ? 0.01 : 0.0254;
        case Setting::Unit::kAngle:
            return std::numbers::pi / 180;
        default:
            return 1.0;
    }
}

}  // namespace percussionist::tracker
