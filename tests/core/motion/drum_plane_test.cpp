#include "core/motion/drum_plane.hpp"

#include <doctest/doctest.h>

#include <random>
#include <stdexcept>
#include <vector>

using namespace percussionist::motion;

TEST_CASE("taps with a round tip give the surface, from whichever side") {
    std::mt19937 random(6);
    std::normal_distribution<> number;
    const auto vector = [&](double scale) {
        return Vector3(scale * number(random), scale * number(random), scale * number(random));
    };
    for (int run = 0; run < 50; ++run) {
        const Pose truth{vector(0.5), percussionist::linear::quaternion_exp(vector(1.5))};
        const Vector3 z = truth.orientation * Vector3::UnitZ();
        std::vector<Vector3> taps;
        for (int i = 0; i < 6; ++i) {
            const Vector3 on_drum(0.1 * number(random), 0.1 * number(random), 0.0125);
            taps.push_back(truth * on_drum + vector(2e-4));
        }
        const FittedPlane fitted = fit_plane(taps, truth * Vector3(0.02, 0.0, 0.3), 0.0125);
        const Vector3 normal = fitted.world_from_drum.orientation * Vector3::UnitZ();
        CHECK(normal.dot(z) > 0.9995);
        CHECK(std::abs((truth.inverse() * fitted.world_from_drum.position).z()) < 1e-3);
        CHECK(fitted.residual < 1e-3);
        // The frame is a rotation, x level as nearly as can be.
        const auto axes = fitted.world_from_drum.orientation.toRotationMatrix();
        CHECK(axes.determinant() == doctest::Approx(1));
        if (std::abs(normal.z()) < 0.9) {
            CHECK(std::abs(axes(2, 0)) < 1e-9);
        }
    }
}

TEST_CASE("two taps, or taps on a line, are no plane") {
    const std::vector<Vector3> two = {{0, 0, 0}, {1, 0, 0}};
    const std::vector<Vector3> line = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0.3, 1e-4, 0}};
    CHECK_THROWS_WITH_AS(fit_plane(two, Vector3::UnitZ(), 0.01), "expected 3 taps or more, got 2",
                         std::invalid_argument);
    CHECK_THROWS_AS(fit_plane(line, Vector3::UnitZ(), 0.01), std::invalid_argument);
}
