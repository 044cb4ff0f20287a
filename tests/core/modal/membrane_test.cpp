#include "core/modal/membrane.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace percussionist::modal;

TEST_CASE("the zeros of the Bessel functions are the tabulated ones") {
    CHECK(bessel_zero(0, 1) == doctest::Approx(2.404825557695773).epsilon(1e-14));
    CHECK(bessel_zero(1, 1) == doctest::Approx(3.831705970207512).epsilon(1e-14));
    CHECK(bessel_zero(0, 3) == doctest::Approx(8.653727912911012).epsilon(1e-14));
    CHECK(bessel_zero(5, 1) == doctest::Approx(8.771483815959954).epsilon(1e-14));
}

TEST_CASE("every zero is one, and none is left out: they interlace with those of the next order") {
    for (int m = 0; m < 40; ++m) {
        for (int n = 1; n < 15; ++n) {
            const double zero = bessel_zero(m, n);
            CHECK(std::abs(std::cyl_bessel_j(m, zero)) < 1e-13);
            CHECK(zero < bessel_zero(m + 1, n));
            CHECK(bessel_zero(m + 1, n) < bessel_zero(m, n + 1));
        }
    }
}

TEST_CASE("modes come lowest first, in the ratios of theory") {
    const auto modes = membrane_modes({}, 200);
    const double ratios[] = {1.0, 1.5933, 1.5933, 2.1355, 2.1355, 2.2954, 2.6531, 2.6531, 2.9173};
    for (int i = 0; i < 9; ++i) {
        CHECK(modes[i].angular_frequency / modes[0].angular_frequency ==
              doctest::Approx(ratios[i]).epsilon(1e-4));
    }
    for (std::size_t i = 1; i < modes.size(); ++i) {
        CHECK(modes[i].angular_frequency >= modes[i - 1].angular_frequency);
    }
}

TEST_CASE("as many modes lie below a frequency as the literature counts") {
    Membrane membrane;
    const double scale =
        100.0 * 2 * std::numbers::pi / membrane_modes(membrane, 1)[0].angular_frequency;
    membrane.tension *= scale * scale;
    const auto modes = membrane_modes(membrane, 700);
    int below = 0;
    for (const auto& mode : modes) {
        below += mode.angular_frequency <= 2000.0 * 2 * std::numbers::pi;
    }
    CHECK(below == 557);
}

TEST_CASE("the modal mass is the integral of density times the shape squared") {
    const Membrane membrane;
    for (const auto& mode : membrane_modes(membrane, 20)) {
        double integral = 0.0;
        const int rings = 400, spokes = 64;
        for (int i = 0; i < rings; ++i) {
            const double r = (i + 0.5) * membrane.radius / rings;
            for (int k = 0; k < spokes; ++k) {
                const double theta = 2 * std::numbers::pi * k / spokes;
                const double phi = mode.shape(r, theta);
                integral += phi * phi * r;
            }
        }
        integral *=
            membrane.surface_density * membrane.radius / rings * 2 * std::numbers::pi / spokes;
        CHECK(mode.modal_mass == doctest::Approx(integral).epsilon(1e-4));
    }
}

TEST_CASE("a drum that cannot be is refused by name") {
    CHECK_THROWS_AS(membrane_modes({.radius = 0.0}, 1), std::invalid_argument);
    CHECK_THROWS_AS(membrane_modes({.tension = -1.0}, 1), std::invalid_argument);
    CHECK_THROWS_AS(membrane_modes({.surface_density = std::nan("")}, 1), std::invalid_argument);
}
