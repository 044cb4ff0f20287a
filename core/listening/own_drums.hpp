// Drums learnt from a few strokes of the player's own: templates of what a stroke adds.
//
// A stroke's print is the power that it adds in 16 bands at three moments within 45 ms, as
// logarithms against all that it adds: how loud it was does not matter. A drum is the mean of its
// strokes' prints and how they spread; drums struck together can be learnt as one more drum. A
// stroke is of the drum whose print is nearest, in deviations, and nearer than kFar.
//
// Plain values of fixed size; functions marked noexcept do not allocate.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/listening/band_analyser.hpp"

namespace percussionist::listening {

constexpr std::size_t kPrint = 3 * kLevels / 2;
using StrokePrint = std::array<float, kPrint>;

/// Of the attack at frames[at].
StrokePrint print_of(std::span<const BandFrame> frames, std::size_t at) noexcept;

struct OwnDrum {
    static constexpr std::size_t kLongestName = 31;
    std::array<char, kLongestName + 1> name{};  ///< ends with 0
    int strokes = 0;                            ///< it was learnt from
    StrokePrint mean{}, square{};               ///< of prints, and of their squares
    float loudest = -30.0F;                     ///< power added by the loudest stroke [nats]

    void learn(const StrokePrint& print, float power) noexcept;
    /// In deviations, a mean over the print.
    [[nodiscard]] float distance(const StrokePrint& print) const noexcept;
};

class OwnDrums {
  public:
    static constexpr std::size_t kMost = 16;
    static constexpr float kFar = 2.2F;  ///< deviations

    /// The drum of that name, made new if there is none; none if there is no room, or the name
    /// is empty, too long or holds spaces.
    std::optional<std::size_t> named(std::string_view name) noexcept;
    void forget(std::size_t drum) noexcept { drums_[drum].strokes = 0; }
    void clear() noexcept { count_ = 0; }

    [[nodiscard]] std::size_t size() const noexcept { return count_; }
    [[nodiscard]] OwnDrum& operator[](std::size_t i) noexcept { return drums_[i]; }
    [[nodiscard]] const OwnDrum& operator[](std::size_t i) const noexcept { return drums_[i]; }

    struct Match {
        std::size_t drum = 0;
        double confidence = 0.5;  ///< 0.5 where two are equally near, to 1
    };
    [[nodiscard]] std::optional<Match> nearest(const StrokePrint& print) const noexcept;

  private:
    std::array<OwnDrum, kMost> drums_{};
    std::size_t count_ = 0;
};

/// A line for each drum.
std::string to_text(const OwnDrums& drums);
/// Throws std::invalid_argument, which says what was expected in which line.
OwnDrums own_drums_from_text(std::string_view text);

}  // namespace percussionist::listening
