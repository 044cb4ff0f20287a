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
/// A step of Newton's so small a part of what the law varies over leaves an error of its square.
constexpr double kNear = 2e-8;
/// Of mu v, within one step: what is lost then is right to some 1e-3 of what is left.
constexpr double kHaste = 0.1;

void require(bool good, const char* name, const char* expected, double value) {
    if (!good) {
        throw std::invalid_argument(std::string("mallet: ") + name + ": expected " + expected +
                                    ", got " + std::to_string(value));
    }
}

double power(double x, double exponent) noexcept {
    if (exponent == 1.5) {
        return x * std::sqrt(x);
    }
    return exponent == 2.0 ? x * x : std::pow(x, exponent);
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
    if (std::abs(y) < 0.01 * middle) {
        // The quotient would cancel: Taylor's series about the middle, its next term below 1e-17.
        const double part = 1 / middle;
        const double bend = y * part;
        const double c2 = a * (a - 1) * (1.0 / 24);
        const double c4 = c2 * (a - 2) * (a - 3) * (1.0 / 80);
        const double e = bend * bend;
        const double at_middle = mallet.stiffness * power(middle, a);
        const double series = 1 + e * (c2 + e * c4);
        const double bend_slope = (1 - 0.5 * bend) * part;
        const double series_slope = bend * (2 * c2 + 4 * e * c4) * bend_slope;
        return {at_middle * series, at_middle * (0.5 * a * part * series + series_slope)};
    }
    const double end_force = end > 0.0 ? mallet.stiffness * power(end, a) : 0.0;
    const double end_potential = end > 0.0 ? end_force * end / (a + 1) : 0.0;
    const double part = 1 / y;
    const double value = (end_potential - potential) * part;
    return {value, (end_force - value) * part};
}

/// atanh(e) / e - 1 and its derivative.
Slope excess(double e) noexcept {
    const double square = e * e;
    if (square < 0.01) {
        return {square * (1.0 / 3 + square * (1.0 / 5 + square * (1.0 / 7 + square * (1.0 / 9)))),
                e * (2.0 / 3 + square * (4.0 / 5 + square * (6.0 / 7)))};
    }
    const double ratio = std::atanh(e) / e;
    return {ratio - 1, (1 / (1 - square) - ratio) / e};
}

/// The header's damping and its derivative by y.
Slope damping(const Mallet& mallet, const ContactStep& step, double y) noexcept {
    const double slope = mallet.dissipation / step.duration;
    const double p = 1 + slope * y;
    if (!(p > 0.0)) {
        return {0.0, 0.0};
    }
    const double start = mallet.dissipation * step.rate;
    const double end = 2 * (p - 1) - start;  // mu v1
    if (start == end || !(start * end >= 0.0 && start > -1.0)) {
        return {p, slope};
    }
    if (end <= -1.0) {
        return {0.0, 0.0};
    }
    const double part = 1 / p;
    const double e = (p - 1 - start) * part;
    const Slope more = excess(e);
    const double below = p - 1 - more.value;
    const double per_below = 1 / below;
    const double value = p * (p - 1) * per_below;
    const double below_slope = slope * (1 - more.derivative * (1 - e) * part);
    return {value, (slope * (2 * p - 1) - value * below_slope) * per_below};
}

/// The whole law: discrete gradient times damping.
Slope force_law(const Mallet& mallet, const ContactStep& step, double potential,
                double y) noexcept {
    const Slope damped = damping(mallet, step, y);
    if (!(damped.value > 0.0)) {
        return {0.0, 0.0};
    }
    const Slope elastic = mean_force(mallet, step.compression, potential, y);
    return {elastic.value * damped.value,
            elastic.derivative * damped.value + elastic.value * damped.derivative};
}

/// By how much y may change before the law is another.
double reach(const Mallet& mallet, const ContactStep& step, double y) noexcept {
    const double depth = std::max(step.compression, step.compression + y);
    const double of_damping = step.duration + mallet.dissipation * y;
    return mallet.dissipation * depth > of_damping ? of_damping / mallet.dissipation : depth;
}

/// Where the bodies' answer meets the law.
double solve(const Mallet& mallet, const ContactStep& step, double guess) noexcept {
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    const double free = step.free_change;
    const double tolerance = kEpsilon * (std::abs(step.compression) + std::abs(free));
    const double potential = contact_potential(mallet, step.compression);
    double low = -std::numeric_limits<double>::infinity();
    double high = free;
    double y = std::min(free, free - step.compliance * guess);
    for (int i = 0; i < kMostIterations; ++i) {
        if (y == 0.0) {
            y = 0.5 * tolerance;  // the quotient's one gap
        }
        const Slope law = force_law(mallet, step, potential, y);
        const double missing = y - free + step.compliance * law.value;
        (missing > 0.0 ? high : low) = y;
        double next = y - missing / (1 + step.compliance * std::max(law.derivative, 0.0));
        // Newton's error is squared by each step: what the next would add is below rounding.
        if (!(std::abs(next - y) > std::max(tolerance, kNear * reach(mallet, step, y)))) {
            return law.value + law.derivative * (next - y);
        }
        if (!(next > low && next < high)) {
            // Without a lower end yet: with less compression comes less force.
            next = std::isinf(low) ? free - step.compliance * law.value : 0.5 * (low + high);
        }
        if (high - low <= tolerance) {
            break;  // the law jumps here
        }
        y = next;
    }
    return (free - y) / step.compliance;
}

double pressing_force(const Mallet& mallet, const ContactStep& step, double guess) noexcept {
    const double d = step.compression;
    const double free = step.free_change;
    // Pushing only ever opens the contact: what stays apart when free is not touching. False for
    // NaN.
    if (!((d > 0.0 || d + free > 0.0) && step.compliance > 0.0)) {
        return 0.0;
    }
    double force = 0.0;
    if (mallet.exponent == 1.0 && mallet.dissipation == 0.0 && d >= 0.0) {
        force =
            mallet.stiffness * (d + 0.5 * free) / (1 + 0.5 * step.compliance * mallet.stiffness);
        if (d + free - step.compliance * force >= 0.0) {
            return std::clamp(force, 0.0, kGreatestForce);
        }
    }
    force = solve(mallet, step, guess);
    return force > 0.0 ? std::min(force, kGreatestForce) : 0.0;
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
    require(std::isfinite(mallet.stickiness) && mallet.stickiness >= 0.0, "stickiness",
            "a number of 0 or more [N]", mallet.stickiness);
}

double contact_potential(const Mallet& mallet, double compression) noexcept {
    if (!(compression > 0.0)) {
        return 0.0;
    }
    return mallet.stiffness * power(compression, mallet.exponent) * compression /
           (mallet.exponent + 1);
}

double contact_force(const Mallet& mallet, const ContactStep& step, double guess) noexcept {
    const double force = pressing_force(mallet, step, guess);
    if (!step.stuck || !(step.compliance > 0.0)) {
        return force;
    }
    if (!(step.free_change - step.compliance * force < 0.0)) {
        return force;  // not parting
    }
    ContactStep pulled = step;
    pulled.free_change += step.compliance * mallet.stickiness;
    const double against = pressing_force(mallet, pulled, guess);
    if (pulled.free_change - step.compliance * against <= 0.0) {
        return against - mallet.stickiness;
    }
    return std::clamp(step.free_change / step.compliance, -mallet.stickiness, kGreatestForce);
}

bool turns_hastily(const Mallet& mallet, const ContactStep& step, double force) noexcept {
    if (!(force > 0.0 && step.rate > 0.0 && mallet.dissipation > 0.0)) {
        return false;
    }
    const double y = step.free_change - step.compliance * force;
    const double end = 2 * y / step.duration - step.rate;
    return end < 0.0 && mallet.dissipation * (step.rate - end) > kHaste;
}

}  // namespace percussionist::modal
