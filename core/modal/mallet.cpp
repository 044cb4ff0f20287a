#include "core/modal/mallet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

/// Far beyond any hand; keeps absurd input from becoming infinite.
constexpr double kGreatestForce = 1e9;
constexpr int kMostIterations = 100;

void require(bool good, const char* name, const char* expected, double value) {
    if (!good) {
        throw std::invalid_argument(std::string("mallet: ") + name + ": expected " + expected +
                                    ", got " + std::to_string(value));
    }
}

struct Slope {
    double value;
    double derivative;
};

/// (V(d + y) - V(d)) / y and its derivative by y, V(d) being `potential`.
Slope mean_force(const Mallet& mallet, double d, double potential, double y) noexcept {
    const double a = mallet.exponent;
    const double end = d + y;
    const double middle = d + 0.5 * y;
    const double bend = y / middle;
    if (std::abs(bend) < 0.01 && middle > 0.0) {
        // The quotient would cancel: Taylor's series about the middle, its next term below 1e-17.
        const double c2 = a * (a - 1) / 24;
        const double c4 = c2 * (a - 2) * (a - 3) / 80;
        const double e = bend * bend;
        const double power = mallet.stiffness * std::pow(middle, a);
        const double series = 1 + e * (c2 + e * c4);
        const double bend_slope = (1 - 0.5 * bend) / middle;
        const double series_slope = bend * (2 * c2 + 4 * e * c4) * bend_slope;
        return {power * series, power * (0.5 * a / middle * series + series_slope)};
    }
    const double end_force = end > 0.0 ? mallet.stiffness * std::pow(end, a) : 0.0;
    const double end_potential = end > 0.0 ? end_force * end / (a + 1) : 0.0;
    const double value = (end_potential - potential) / y;
    return {value, (end_force - value) / y};
}

/// The whole law: discrete gradient times damping.
Slope force_law(const Mallet& mallet, const ContactStep& step, double potential,
                double y) noexcept {
    const double rate = mallet.dissipation / step.duration;
    const double damping = 1 + rate * y;
    if (!(damping > 0.0)) {
        return {0.0, 0.0};
    }
    const Slope elastic = mean_force(mallet, step.compression, potential, y);
    return {elastic.value * damping, elastic.derivative * damping + elastic.value * rate};
}

}  // namespace

void check(const Mallet& mallet) {
    const auto above_zero = [](double x) { return std::isfinite(x) && x > 0.0; };
    require(above_zero(mallet.mass), "mass", "a number above 0 [kg]", mallet.mass);
    require(above_zero(mallet.stiffness) && mallet.stiffness <= 1e12, "stiffness",
            "a number above 0, at most 1e12 [N/m^a]", mallet.stiffness);
    require(mallet.exponent >= 1.0 && mallet.exponent <= 5.0, "exponent", "a number from 1 to 5",
            mallet.exponent);
    require(std::isfinite(mallet.dissipation) && mallet.dissipation >= 0.0, "dissipation",
            "a number of 0 or more [s/m]", mallet.dissipation);
}

double contact_potential(const Mallet& mallet, double compression) noexcept {
    if (!(compression > 0.0)) {
        return 0.0;
    }
    return mallet.stiffness * std::pow(compression, mallet.exponent) * compression /
           (mallet.exponent + 1);
}

double contact_force(const Mallet& mallet, const ContactStep& step, double guess) noexcept {
    const double d = step.compression;
    const double free = step.free_change;
    // Pushing only ever opens the contact: what stays apart when free is not touching. False for
    // NaN.
    if (!((d > 0.0 || d + free > 0.0) && step.compliance > 0.0)) {
        return 0.0;
    }
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    const double tolerance = kEpsilon * (std::abs(d) + std::abs(free));
    const double potential = contact_potential(mallet, d);
    double y = std::min(free, free - step.compliance * guess);
    double force = 0.0;
    for (int i = 0; i < kMostIterations; ++i) {
        if (y == 0.0) {
            y = 0.5 * tolerance;  // the quotient's one gap
        }
        const Slope law = force_law(mallet, step, potential, y);
        force = law.value;
        const double next = std::min(free, y - (y - free + step.compliance * law.value) /
                                                   (1 + step.compliance * law.derivative));
        const double moved = std::abs(next - y);
        if (!(moved > tolerance)) {
            break;
        }
        y = next;
    }
    return force > 0.0 ? std::min(force, kGreatestForce) : 0.0;
}

}  // namespace percussionist::modal
