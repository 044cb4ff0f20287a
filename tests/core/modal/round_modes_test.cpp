#include "core/modal/round_modes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/modal/bessel_table.hpp"
#include "core/modal/membrane.hpp"
#include "core/modal/plate.hpp"

using namespace percussionist::modal;
using std::numbers::pi;

namespace {

/// Integral over the body, by rings and spokes.
template <class F>
double integral(double radius, const F& f) {
    constexpr int kRings = 600, kSpokes = 48;
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        const double r = (i + 0.5) * radius / kRings;
        for (int k = 0; k < kSpokes; ++k) {
            sum += f(r, 2 * pi * k / kSpokes) * r;
        }
    }
    return sum * radius / kRings * 2 * pi / kSpokes;
}

}  // namespace

TEST_CASE("the table's Bessel functions are the library's") {
    const auto& table = BesselTable::shared();
    for (const int m : {0, 1, 2, 7, 30, 120}) {
        for (double x = 0.0; x < 205; x += 0.61803) {
            // The library's own arguments lose digits as they grow: it is asked for more.
            const long double order = m, precise = x;
            CHECK(std::abs(table.j(m, x) - static_cast<double>(std::cyl_bessel_j(order, precise))) <
                  2e-15);
            const double scaled =
                static_cast<double>(std::cyl_bessel_i(order, precise) * std::exp(-precise));
            CHECK(table.scaled_i(m, x) == doctest::Approx(scaled).epsilon(1e-12));
        }
    }
}

TEST_CASE("a free plate's frequencies are the literature's") {
    // Leissa 1969, nu = 0.33: (w R^2 sqrt(density / D)) of (m, n).
    const auto modes = plate_modes({}, 60);
    const auto root = [&](int m, int n) {
        for (const auto& mode : modes) {
            if (mode.diameters == m && mode.circles == n) {
                return mode.root * mode.root;
            }
        }
        return 0.0;
    };
    CHECK(root(2, 0) == doctest::Approx(5.253).epsilon(0.002));
    CHECK(root(0, 1) == doctest::Approx(9.084).epsilon(0.002));
    CHECK(root(3, 0) == doctest::Approx(12.23).epsilon(0.002));
    CHECK(root(1, 1) == doctest::Approx(20.52).epsilon(0.002));
    CHECK(root(4, 0) == doctest::Approx(21.6).epsilon(0.01));
    CHECK(root(0, 2) == doctest::Approx(38.55).epsilon(0.005));
}

TEST_CASE("a plate's modes do not feel each other, and weigh their integral") {
    const Plate plate;
    const auto modes = plate_modes(plate, 24);
    const double density = plate.density * plate.thickness;
    for (std::size_t j = 0; j < modes.size(); j += 3) {
        for (std::size_t k = j; k < modes.size(); k += 4) {
            const double product = integral(plate.radius, [&](double r, double theta) {
                return density * modes[j].shape(r, theta) * modes[k].shape(r, theta);
            });
            const double expected = j == k ? modes[j].modal_mass : 0.0;
            CHECK(std::abs(product - expected) <
                  2e-3 * std::sqrt(modes[j].modal_mass * modes[k].modal_mass));
        }
    }
}

TEST_CASE("a shape averaged over a disc is the mean of the shape in it") {
    for (const auto& modes : {membrane_modes({}, 30), plate_modes({.radius = 0.33}, 30)}) {
        const Spot spot{0.15, 0.4, 0.05};
        std::vector<double> values(modes.size());
        evaluate_shapes(modes, spot, values);
        for (std::size_t k = 0; k < modes.size(); ++k) {
            const double sum = integral(spot.spread, [&](double r, double angle) {
                const double x = spot.r * std::cos(spot.theta) + r * std::cos(angle);
                const double y = spot.r * std::sin(spot.theta) + r * std::sin(angle);
                return modes[k].shape(std::hypot(x, y), std::atan2(y, x));
            });
            const double mean = sum / (pi * spot.spread * spot.spread);
            CHECK(values[k] == doctest::Approx(mean).epsilon(1e-4).scale(1e-2));
        }
    }
}

TEST_CASE("what is heard afar is Rayleigh's integral") {
    const double elevation = 0.7, azimuth = 0.3;
    for (const auto& modes : {membrane_modes({.tension = 20000}, 12), plate_modes({}, 12)}) {
        for (const auto& mode : modes) {
            const double k = mode.angular_frequency / kSoundSpeed * std::sin(elevation);
            const auto part = [&](bool real) {
                return integral(mode.radius, [&](double r, double theta) {
                    const double path = k * r * std::cos(theta - azimuth);
                    return mode.shape(r, theta) * (real ? std::cos(path) : std::sin(path));
                });
            };
            const bool even = mode.diameters % 2 == 0;
            const double sign = mode.diameters % 4 < 2 ? 1.0 : -1.0;
            CHECK(radiation(mode, elevation, azimuth) ==
                  doctest::Approx(sign * part(even)).epsilon(1e-3).scale(1e-3));
        }
    }
}

TEST_CASE("air lowers the lowest modes most, a cavity raises those without diameters") {
    const auto bare = membrane_modes({}, 30);
    const auto loaded = membrane_modes({.air_density = 1.2}, 30);
    const auto closed = membrane_modes({.air_density = 1.2, .cavity = 0.1}, 30);
    double last = 0.0;
    for (std::size_t k = 0; k < 30; ++k) {
        const double ratio = loaded[k].angular_frequency / bare[k].angular_frequency;
        CHECK(ratio >= last);
        CHECK(ratio < 1.0);
        last = ratio;
        CHECK((closed[k].angular_frequency > loaded[k].angular_frequency) ==
              (bare[k].diameters == 0));
    }
    CHECK(membrane_modes({.bending = 0.1}, 30)[29].angular_frequency > bare[29].angular_frequency);
}

TEST_CASE("8192 modes are had, in order, each with its zero at the rim") {
    const auto modes = membrane_modes({}, 8192);
    REQUIRE(modes.size() == 8192);
    for (std::size_t k = 1; k < modes.size(); ++k) {
        REQUIRE(modes[k].root >= modes[k - 1].root);
    }
    CHECK(std::abs(BesselTable::shared().j(modes.back().diameters, modes.back().root)) < 1e-12);
    CHECK(plate_modes({}, 8192).size() == 8192);
}
