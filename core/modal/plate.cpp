#include "core/modal/plate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/modal/bessel_table.hpp"
#include "core/modal/membrane.hpp"
#include "core/modal/root_search.hpp"

namespace percussionist::modal {

namespace {

/// Moment and shear force at the edge r = 1 of a term of the shape, over what they have in common.
struct Edge {
    double moment;
    double shear;
};

/// Of J_m(x r). With J'' out of Bessel's equation.
Edge edge_of_j(int m, double x, double poisson) {
    const auto& table = BesselTable::shared();
    const double f = table.j(m, x);
    const double slope = m * f - x * table.j(m + 1, x);  // x J'
    const double bent = (1 - poisson) * m * m;
    return {-(1 - poisson) * slope - (x * x - bent) * f, -x * x * slope - bent * (slope - f)};
}

/// Of exp(-x) I_m(x r).
Edge edge_of_i(int m, double x, double poisson) {
    const auto& table = BesselTable::shared();
    const double f = table.scaled_i(m, x);
    const double slope = m * f + x * table.scaled_i(m + 1, x);
    const double bent = (1 - poisson) * m * m;
    return {-(1 - poisson) * slope + (x * x + bent) * f, x * x * slope - bent * (slope - f)};
}

double condition(int m, double x, double poisson) {
    const Edge j = edge_of_j(m, x, poisson);
    const Edge i = edge_of_i(m, x, poisson);
    return (j.moment * i.shear - i.moment * j.shear) / (i.moment * i.moment + i.shear * i.shear);
}

/// Twice the integral of phi^2 r dr from 0 to 1: the mean of phi^2 but for its angle. Simpson's
/// rule, some 60 points a wave.
double mean_square(RoundMode mode) {
    mode.radius = 1.0;
    mode.sine = false;
    const int intervals = 2 * (16 + static_cast<int>(mode.root * 8));
    double sum = 0.0;
    for (int i = 1; i <= intervals; ++i) {
        const double r = static_cast<double>(i) / intervals;
        const double phi = mode.shape(r, 0.0);
        sum += (i == intervals ? 1 : i % 2 != 0 ? 4 : 2) * phi * phi * r;
    }
    return 2 * sum / (3 * intervals);
}

void require(bool good, const char* name, const char* expected, double value) {
    if (!(good && std::isfinite(value))) {
        throw std::invalid_argument(std::string("plate: ") + name + ": expected a finite number " +
                                    expected + ", got " + std::to_string(value));
    }
}

}  // namespace

void check(const Plate& plate) {
    require(plate.radius > 0.0, "radius", "above 0 [m]", plate.radius);
    require(plate.thickness > 0.0, "thickness", "above 0 [m]", plate.thickness);
    require(plate.stiffness > 0.0, "stiffness", "above 0 [Pa]", plate.stiffness);
    require(plate.density > 0.0, "density", "above 0 [kg/m^3]", plate.density);
    require(plate.poisson >= 0.0 && plate.poisson <= 0.5, "poisson", "from 0 to 0.5",
            plate.poisson);
}

std::vector<RoundMode> plate_modes(const Plate& plate, std::size_t count) {
    check(plate);
    count = std::min(count, kMostModes);
    std::vector<RoundMode> modes;
    modes.reserve(count);
    const double nu = plate.poisson;
    const auto root_after = [nu](int m, double from) {
        return next_root([m, nu](double x) { return condition(m, x, nu); }, from);
    };
    const auto take = [&](const Root& root) {
        RoundMode mode;
        mode.diameters = root.m;
        mode.circles = root.m < 2 ? root.n : root.n - 1;
        mode.root = root.x;
        mode.bend = -edge_of_j(root.m, root.x, nu).moment / edge_of_i(root.m, root.x, nu).moment;
        mode.mass_fraction = mean_square(mode) * (root.m == 0 ? 1.0 : 0.5);
        modes.push_back(mode);
        if (root.m > 0 && modes.size() < count) {
            mode.sine = true;
            modes.push_back(mode);
        }
        return modes.size() < count;
    };
    constexpr double kPastRoot = 0.1;
    in_order(
        2, [&](int m, double x) { return root_after(m, x + kPastRoot); },
        [&](int m) { return root_after(m, m < 2 ? 1.0 : 0.9 * m); }, take);
    retune(modes, plate);
    return modes;
}

void retune(std::vector<RoundMode>& modes, const Plate& plate) {
    check(plate);
    const double h = plate.thickness;
    const double bending = plate.stiffness * h * h * h / (12 * (1 - plate.poisson * plate.poisson));
    const double density = plate.density * h;
    const double mass = density * std::numbers::pi * plate.radius * plate.radius;
    for (auto& mode : modes) {
        const double k = mode.root / plate.radius;
        mode.radius = plate.radius;
        mode.angular_frequency = k * k * std::sqrt(bending / density);
        mode.modal_mass = mode.mass_fraction * mass;
    }
}

}  // namespace percussionist::modal
