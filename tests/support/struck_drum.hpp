// A drum as a sum of decaying partials, struck by mallets: what the onsets are known of.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace percussionist::test {

constexpr double kRate = 48000.0;
constexpr double kNoise = 1e-5;  ///< that of 16-bit audio
struct Struck {
    double time;       ///< [s]
    double amplitude;  ///< of the force
};

/// The forces of mallets on a head for `contact` [s] each, as Hertz has them.
inline std::vector<double> forces(const std::vector<Struck>& strokes, double contact,
                                  double length) {
    std::vector<double> force(static_cast<std::size_t>(length * kRate));
    for (const Struck& s : strokes) {
        for (std::size_t n = 0; n < force.size(); ++n) {
            const double into = static_cast<double>(n) / kRate - s.time;
            if (into > 0.0 && into < contact) {
                force[n] +=
                    s.amplitude * std::pow(std::sin(std::numbers::pi * into / contact), 1.5);
            }
        }
    }
    return force;
}

/// A head of 60 partials from 90 Hz to 4 kHz, the lowest ringing on for seconds, in faint noise.
inline std::vector<double> drum(const std::vector<Struck>& strokes, double contact, double length) {
    const std::vector<double> force = forces(strokes, contact, length);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> out(force.size());
    for (int m = 0; m < 60; ++m) {
        const double frequency = 90.0 * std::pow(44.0, (m + 0.3 * uniform(random)) / 60);
        const double decay = 0.02 + 0.6 * 90.0 / frequency;
        const double r = std::exp(-1.0 / (decay * kRate));
        const double c = 2.0 * r * std::cos(2.0 * std::numbers::pi * frequency / kRate);
        const double weight = 0.2 + uniform(random);
        double y1 = 0.0, y2 = 0.0;
        for (std::size_t n = 0; n < out.size(); ++n) {
            const double y = c * y1 - r * r * y2 + force[n];
            out[n] += weight * (y - y1);
            y2 = y1;
            y1 = y;
        }
    }
    double peak = 0.0;
    for (const double x : out) {
        peak = std::max(peak, std::abs(x));
    }
    std::normal_distribution<double> normal;
    for (double& x : out) {
        x = x / peak + kNoise * normal(random);
    }
    return out;
}

inline std::vector<double> times_of(const std::vector<Struck>& strokes) {
    std::vector<double> times;
    for (const Struck& s : strokes) {
        times.push_back(s.time);
    }
    return times;
}

/// Every 60 ms a stroke, the loudness wandering by `range_db` but by 12 dB at most from one to the
/// next.
inline std::vector<Struck> wandering(int count, double range_db) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> step(-12.0, 12.0);
    std::vector<Struck> strokes;
    double level = 0.0;
    for (int i = 0; i < count; ++i) {
        strokes.push_back({0.1 + 0.060 * i + 1e-5 * (i % 7), std::pow(10.0, level / 20.0)});
        level = std::clamp(level + step(random), -range_db, 0.0);
    }
    return strokes;
}

}  // namespace percussionist::test
