// Damage on a serial line, as much as is asked for, the same each time.
#pragma once

#include <cstdint>
#include <random>

#include "core/motion/fastrak_record.hpp"

namespace percussionist::tracker {

struct LineFaultSettings {
    double garbage = 0.0;  ///< garbage bytes, as a part of all bytes: 0 to 0.5
    double cut = 0.0;      ///< records cut short, as a part of all: 0 to 1
    std::uint32_t seed = 1;
};

/// Garbage comes in bursts of 1 to 15 bytes, half of them in place of good ones, half in between.
class LineFaults {
  public:
    explicit LineFaults(const LineFaultSettings& settings)
        : settings_(settings), random_(settings.seed) {}

    void set(double garbage, double cut) {
        settings_.garbage = garbage;
        settings_.cut = cut;
    }

    /// True if the record itself is no longer whole.
    bool damage(motion::Bytes& record);

  private:
    double chance() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }
    std::size_t below(std::size_t limit) {
        return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
    }
    bool burst(motion::Bytes& record);

    LineFaultSettings settings_;
    std::mt19937 random_;
};

}  // namespace percussionist::tracker
