#include "core/modal/membrane.hpp"

#include <cmath>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

using std::numbers::pi;

double bessel_j(int m, double x) {
    return std::cyl_bessel_j(static_cast<double>(m), x);
}

double bessel_j_derivative(int m, double x) {
    return m == 0 ? -bessel_j(1, x) : 0.5 * (bessel_j(m - 1, x) - bessel_j(m + 1, x));
}

/// Zeros of J_m are more than 3 apart beyond the first, which lies above m: walk in steps that
/// cannot skip two, then close in by bisection and polish by Newton.
double next_zero(int m, double from) {
    constexpr double kStep = 0.5;
    double low = from;
    const bool below = std::signbit(bessel_j(m, low));
    while (std::signbit(bessel_j(m, low + kStep)) == below) {
        low += kStep;
    }
    double high = low + kStep;
    for (int i = 0; i < 4; ++i) {
        const double middle = 0.5 * (low + high);
        (std::signbit(bessel_j(m, middle)) == below ? low : high) = middle;
    }
    double x = 0.5 * (low + high);
    for (int i = 0; i < 10; ++i) {
        const double change = bessel_j(m, x) / bessel_j_derivative(m, x);
        x -= change;
        if (std::abs(change) < 1e-9 * x) {
            break;  // its square is below rounding
        }
    }
    return x;
}

/// Just past a zero of J_m, from where the next one is sought.
constexpr double kPastZero = 0.1;

void require_positive(double value, const char* name) {
    if (!(std::isfinite(value) && value > 0.0)) {
        throw std::invalid_argument(std::string("membrane: ") + name +
                                    " must be a finite number above 0, not " +
                                    std::to_string(value));
    }
}

struct Candidate {
    int m;
    int n;
    double zero;
    bool operator>(const Candidate& other) const { return zero > other.zero; }
};

}  // namespace

double bessel_zero(int m, int n) {
    double x = next_zero(m, m + kPastZero);
    for (int i = 1; i < n; ++i) {
        x = next_zero(m, x + kPastZero);
    }
    return x;
}

double MembraneMode::shape(double r, double theta) const {
    double value = 0.0;
    evaluate_shapes({this, 1}, r, theta, {&value, 1});
    return value;
}

void evaluate_shapes(std::span<const MembraneMode> modes, double r, double theta,
                     std::span<double> values) {
    double along_radius = 0.0;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const MembraneMode& mode = modes[k];
        const bool second = k > 0 && mode.bessel_zero == modes[k - 1].bessel_zero;
        if (!second) {
            along_radius = r < mode.radius
                               ? bessel_j(mode.diameters, mode.bessel_zero * r / mode.radius)
                               : 0.0;
        }
        const double angle = mode.diameters * theta;
        values[k] = along_radius * (mode.sine ? std::sin(angle) : std::cos(angle));
    }
}

void check(const Membrane& membrane) {
    require_positive(membrane.radius, "radius");
    require_positive(membrane.tension, "tension");
    require_positive(membrane.surface_density, "surface density");
}

std::vector<MembraneMode> membrane_modes(const Membrane& membrane, std::size_t count) {
    check(membrane);
    // For each m the next zero waits in the queue; j_m1 grows with m, so that a new m need only be
    // opened once the one before has given its first.
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> waiting;
    waiting.push({0, 1, bessel_zero(0, 1)});
    std::vector<MembraneMode> modes;
    modes.reserve(count);
    while (modes.size() < count) {
        const Candidate c = waiting.top();
        waiting.pop();
        waiting.push({c.m, c.n + 1, next_zero(c.m, c.zero + kPastZero)});
        if (c.n == 1) {
            waiting.push({c.m + 1, 1, bessel_zero(c.m + 1, 1)});
        }
        const double slope = bessel_j(c.m + 1, c.zero);
        MembraneMode mode;
        mode.diameters = c.m;
        mode.circles = c.n;
        mode.bessel_zero = c.zero;
        mode.mass_fraction = slope * slope * (c.m == 0 ? 1.0 : 0.5);
        modes.push_back(mode);
        if (c.m > 0 && modes.size() < count) {
            mode.sine = true;
            modes.push_back(mode);
        }
    }
    retune(modes, membrane);
    return modes;
}

void retune(std::vector<MembraneMode>& modes, const Membrane& membrane) {
    check(membrane);
    const double wave_speed = std::sqrt(membrane.tension / membrane.surface_density);
    const double mass = membrane.surface_density * pi * membrane.radius * membrane.radius;
    for (auto& mode : modes) {
        mode.radius = membrane.radius;
        mode.angular_frequency = mode.bessel_zero * wave_speed / membrane.radius;
        mode.modal_mass = mode.mass_fraction * mass;
    }
}

}  // namespace percussionist::modal
