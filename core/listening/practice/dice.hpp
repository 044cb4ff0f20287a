// Chance that comes out the same on every machine: the standard's engine, but not its
// distributions, which each library makes in its own way.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace percussionist::listening::practice {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// As likely between 1 and 2 as between 2 and 4; both above 0.
    double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
    /// Nearly Gaussian, of mean 0 and deviation 1, and never beyond 3.5.
    double normal() {
        double sum = 0.0;
        for (int i = 0; i < 4; ++i) sum += uniform(-1.0, 1.0);
        return sum * 0.866;
    }
    bool chance(double probability) { return uniform() < probability; }
    /// 0 .. count - 1
    std::size_t whole(std::size_t count) {
        return static_cast<std::size_t>(uniform() * static_cast<double>(count));
    }
    /// A seed for dice of its own.
    std::uint64_t seed() { return engine_(); }

  private:
    std::mt19937_64 engine_;
};

}  // namespace percussionist::listening::practice
