#include "core/modal/round_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/modal/bessel_table.hpp"

namespace percussionist::modal {

namespace {

constexpr std::size_t kOrders = BesselTable::kOrders;

/// 2 J_1(z) / z, sign -1, or 2 I_1(z) / z, sign 1.
double disc_mean(double z, double sign) noexcept {
    if (z < 0.01) {
        return 1 + sign * z * z / 8;
    }
    if (sign > 0) {
        return 2 * std::exp(z) * BesselTable::shared().scaled_i(1, std::min(z, 200.0)) / z;
    }
    return z < BesselTable::kReach ? 2 * BesselTable::shared().j(1, z) / z : 0.0;
}

double along_radius(const RoundMode& mode, double r, double spread) noexcept {
    const auto& table = BesselTable::shared();
    const double share = r / mode.radius;
    const double x = mode.root * share;
    const double z = mode.root * spread / mode.radius;
    double value = table.j(mode.diameters, x);
    value *= z > 0.0 ? disc_mean(z, -1.0) : 1.0;
    if (mode.bend != 0.0) {
        const double edge = mode.bend * std::exp(x - mode.root) * table.scaled_i(mode.diameters, x);
        value += edge * (z > 0.0 ? disc_mean(z, 1.0) : 1.0);
    }
    return value;
}

/// cos(m theta) and sin(m theta) of all orders up to `most`.
struct Turns {
    std::array<double, kOrders> cosine, sine;

    Turns(double theta, int most) {
        const double c = std::cos(theta), s = std::sin(theta);
        cosine[0] = 1.0;
        sine[0] = 0.0;
        for (int m = 1; m <= most; ++m) {
            cosine[m] = cosine[m - 1] * c - sine[m - 1] * s;
            sine[m] = sine[m - 1] * c + cosine[m - 1] * s;
        }
    }
};

/// The integral of J_m(a r) J_m(b r) r dr from 0 to 1.
double lommel(int m, double a, double b) noexcept {
    const auto& table = BesselTable::shared();
    const auto j = [&](int order, double x) { return table.j(order, x); };
    if (std::abs(a - b) < 1e-4 * (a + b)) {
        const double x = 0.5 * (a + b);
        const double below = m == 0 ? -j(1, x) : j(m - 1, x);
        return 0.5 * (j(m, x) * j(m, x) - below * j(m + 1, x));
    }
    return (a * j(m + 1, a) * j(m, b) - b * j(m, a) * j(m + 1, b)) / (a * a - b * b);
}

/// exp(-a) times the integral of I_m(a r) J_m(b r) r dr from 0 to 1.
double lommel_scaled_i(int m, double a, double b) noexcept {
    const auto& table = BesselTable::shared();
    return (a * table.scaled_i(m + 1, a) * table.j(m, b) +
            b * table.scaled_i(m, a) * table.j(m + 1, b)) /
           (a * a + b * b);
}

}  // namespace

double RoundMode::shape(double r, double theta) const noexcept {
    double value = 0.0;
    evaluate_shapes({this, 1}, {r, theta, 0.0}, {&value, 1});
    return value;
}

void evaluate_shapes(std::span<const RoundMode> modes, const Spot& spot,
                     std::span<double> values) noexcept {
    int most = 0;
    for (const auto& mode : modes) {
        most = std::max(most, mode.diameters);
    }
    const Turns turns(spot.theta, most);
    double radial = 0.0;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const RoundMode& mode = modes[k];
        const bool second = mode.sine && k > 0 && mode.root == modes[k - 1].root;
        if (!second) {
            // The rim of a membrane stays where it is; that of a plate does not.
            const bool on = spot.r < mode.radius || (mode.bend != 0.0 && spot.r == mode.radius);
            radial = on ? along_radius(mode, spot.r, spot.spread) : 0.0;
        }
        values[k] =
            radial * (mode.sine ? turns.sine[mode.diameters] : turns.cosine[mode.diameters]);
    }
}

double radiation(const RoundMode& mode, double elevation, double azimuth) noexcept {
    const double b =
        std::min(mode.angular_frequency / kSoundSpeed * mode.radius * std::abs(std::sin(elevation)),
                 BesselTable::kReach - 1);
    const int m = mode.diameters;
    double integral = lommel(m, mode.root, b);
    if (mode.bend != 0.0) {
        integral += mode.bend * lommel_scaled_i(m, mode.root, b);
    }
    const double angle = m * azimuth;
    return 2 * std::numbers::pi * mode.radius * mode.radius * integral *
           (mode.sine ? std::sin(angle) : std::cos(angle));
}

}  // namespace percussionist::modal
