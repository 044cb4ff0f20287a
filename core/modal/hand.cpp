#include "core/modal/hand.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

constexpr double kFleshDepth = 0.002;      ///< [m]
constexpr double kFleshImpedance = 5000;   ///< [Pa s/m]
constexpr double kSeatingPressure = 2000;  ///< [Pa]
/// A hand no larger is one spot: a finger [m^2].
constexpr double kFinger = 4e-4;

}  // namespace

void check(const Hand& hand) {
    const bool good = std::isfinite(hand.r) && hand.r >= 0.0 && std::isfinite(hand.theta) &&
                      hand.area > 0.0 && hand.area <= 0.1 && hand.pressure >= 0.0 &&
                      hand.pressure <= 1e6;
    if (!good) {
        throw std::invalid_argument(
            "hand: expected r of 0 or more [m], theta [rad], an area above 0 to 0.1 [m^2] and a "
            "pressure from 0 to 1e6 [Pa], got " +
            std::to_string(hand.r) + " " + std::to_string(hand.theta) + " " +
            std::to_string(hand.area) + " " + std::to_string(hand.pressure));
    }
}

HandPoints points_of(const Hand& hand) noexcept {
    HandPoints points;
    points.count = hand.area > kFinger ? HandPoints::kMost : 1;
    const double share = hand.area / static_cast<double>(points.count);
    const double spread = std::sqrt(share / std::numbers::pi);
    const double seated = hand.pressure / (hand.pressure + kSeatingPressure);
    points.stiffness = share * hand.pressure / kFleshDepth;
    points.resistance = share * kFleshImpedance * seated;
    const double x = hand.r * std::cos(hand.theta);
    const double y = hand.r * std::sin(hand.theta);
    for (std::size_t i = 0; i < points.count; ++i) {
        const double aside = points.count > 1 ? spread : 0.0;
        const double px = x + (i % 2 != 0 ? aside : -aside);
        const double py = y + (i / 2 != 0 ? aside : -aside);
        points.spots[i] = {std::hypot(px, py), std::atan2(py, px), spread};
    }
    return points;
}

}  // namespace percussionist::modal
