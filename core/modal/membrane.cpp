#include "core/modal/membrane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/modal/bessel_table.hpp"
#include "core/modal/root_search.hpp"

namespace percussionist::modal {

namespace {

using std::numbers::pi;

/// Just past a zero of J_m, from where the next one is sought.
constexpr double kPastZero = 0.1;

double next_zero(int m, double from) {
    return next_root([m](double x) { return BesselTable::shared().j(m, x); }, from);
}

void require(bool good, const char* name, const char* expected, double value) {
    if (!(good && std::isfinite(value))) {
        throw std::invalid_argument(std::string("membrane: ") + name +
                                    ": expected a finite number " + expected + ", got " +
                                    std::to_string(value));
    }
}

/// What a unit of area weighs, the air it moves included.
double loaded_density(const Membrane& membrane, double k, double w) {
    const double below_sound = k * k - (w / kSoundSpeed) * (w / kSoundSpeed);
    return below_sound > 0.0
               ? membrane.surface_density + 2 * membrane.air_density / std::sqrt(below_sound)
               : membrane.surface_density;
}

void tune_mode(RoundMode& mode, const Membrane& membrane) {
    const double area = pi * membrane.radius * membrane.radius;
    const double k = mode.root / membrane.radius;
    const double stiffness = (membrane.tension + membrane.bending * k * k) * k * k;
    double density = membrane.surface_density;
    double w = std::sqrt(stiffness / density);
    constexpr int kRounds = 12;  // each gains a digit or more
    for (int i = 0; membrane.air_density > 0.0 && i < kRounds; ++i) {
        density = loaded_density(membrane, k, w);
        w = std::sqrt(stiffness / density);
    }
    mode.radius = membrane.radius;
    mode.modal_mass = mode.mass_fraction * density * area;
    if (membrane.cavity > 0.0 && mode.diameters == 0) {
        // The mean of phi is 2 J_1(x) / x, and J_1(x)^2 the mean of its square.
        const double swept = 2 * area * std::sqrt(mode.mass_fraction) / mode.root;
        const double rho_c2 = membrane.air_density * kSoundSpeed * kSoundSpeed;
        w = std::sqrt(w * w + rho_c2 * swept * swept / membrane.cavity / mode.modal_mass);
    }
    mode.angular_frequency = w;
}

}  // namespace

double bessel_zero(int m, int n) {
    double x = next_zero(m, m + kPastZero);
    for (int i = 1; i < n; ++i) {
        x = next_zero(m, x + kPastZero);
    }
    return x;
}

void check(const Membrane& membrane) {
    require(membrane.radius > 0.0, "radius", "above 0 [m]", membrane.radius);
    require(membrane.tension > 0.0, "tension", "above 0 [N/m]", membrane.tension);
    require(membrane.surface_density > 0.0, "density", "above 0 [kg/m^2]",
            membrane.surface_density);
    require(membrane.bending >= 0.0, "bending", "of 0 or more [N m]", membrane.bending);
    require(membrane.air_density >= 0.0, "air", "of 0 or more [kg/m^3]", membrane.air_density);
    require(membrane.cavity >= 0.0, "cavity", "of 0 or more [m^3]", membrane.cavity);
    require(membrane.stretch >= 0.0, "stretch", "of 0 or more [N/m]", membrane.stretch);
}

std::vector<RoundMode> membrane_modes(const Membrane& membrane, std::size_t count) {
    check(membrane);
    count = std::min(count, kMostModes);
    std::vector<RoundMode> modes;
    modes.reserve(count);
    const auto take = [&](const Root& root) {
        const double slope = BesselTable::shared().j(root.m + 1, root.x);
        RoundMode mode;
        mode.diameters = root.m;
        mode.circles = root.n;
        mode.root = root.x;
        mode.mass_fraction = slope * slope * (root.m == 0 ? 1.0 : 0.5);
        modes.push_back(mode);
        if (root.m > 0 && modes.size() < count) {
            mode.sine = true;
            modes.push_back(mode);
        }
        return modes.size() < count;
    };
    in_order(
        0, [](int m, double x) { return next_zero(m, x + kPastZero); },
        [](int m) { return bessel_zero(m, 1); }, take);
    retune(modes, membrane);
    return modes;
}

void retune(std::vector<RoundMode>& modes, const Membrane& membrane) {
    check(membrane);
    for (auto& mode : modes) {
        tune_mode(mode, membrane);
    }
}

}  // namespace percussionist::modal
