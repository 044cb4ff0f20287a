#include "sim/impact_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "core/modal/struck_membrane.hpp"

namespace percussionist::sim {

namespace {

/// A contact that has not ended by then is one of a stick that stays [s].
constexpr double kLongest = 0.03;

body::Rebound fall(const DrumheadOptions& options, double rate, double mass,
                   const linear::Vector3& place, double speed) {
    modal::StruckMembrane head(options.membrane, options.decay, options.modes, rate);
    head.place(0, std::hypot(place.x(), place.y()), std::atan2(place.y(), place.x()));
    std::array<modal::Striker, 1> tip;
    tip[0].mallet = options.tip;
    tip[0].mallet.mass = mass;
    tip[0].velocity = -speed;
    const int most = static_cast<int>(kLongest * rate);
    for (int i = 1; i <= most; ++i) {
        head.step(tip);
        if (tip[0].velocity > 0.0 && tip[0].force == 0.0) return {tip[0].velocity, i / rate};
    }
    return {std::max(0.0, tip[0].velocity), kLongest};
}

}  // namespace

ImpactForecast::ImpactForecast(const DrumheadOptions& options, double h, double mass,
                               const linear::Vector3& place) {
    const double samples = std::max(1.0, std::round(h * options.fine_rate));
    for (int i = 0; i < kSpeeds; ++i) {
        table_[i] = fall(options, samples / h, mass, place, (i + 1) * kStep);
    }
}

body::Rebound ImpactForecast::rebound(double speed) const {
    const double at = std::max(0.0, speed / kStep - 1.0);
    const int i = std::min(static_cast<int>(at), kSpeeds - 2);
    const double share = std::min(at - i, 1.0);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    const body::Rebound& low = table_[i];
    const body::Rebound& high = table_[i + 1];
    // Rebound speeds are read as shares of the impact's, which change little.
    const double share_low = low.speed / ((i + 1) * kStep);
    const double share_high = high.speed / ((i + 2) * kStep);
    return {between(share_low, share_high) * speed, between(low.duration, high.duration)};
}

}  // namespace percussionist::sim
