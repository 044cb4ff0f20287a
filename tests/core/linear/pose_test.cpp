#include "core/linear/pose.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "core/linear/euler.hpp"

using namespace percussionist::linear;

namespace {

const Pose kA{{0.1, -0.4, 1.0}, quaternion_exp({0.3, -1.0, 0.2})};
const Pose kB{{-2.0, 0.5, 0.3}, quaternion_exp({1.3, 0.4, -0.9})};

}  // namespace

TEST_CASE("poses chain as points move") {
    const Vector3 p(0.2, 0.7, -0.1);
    CHECK(((kA * kB) * p - kA * (kB * p)).norm() < 1e-14);
    CHECK((kA.inverse() * (kA * p) - p).norm() < 1e-14);
}

TEST_CASE("between two poses the way is straight and the turn even") {
    CHECK((interpolate(kA, kB, 0.0).position - kA.position).norm() < 1e-15);
    CHECK(interpolate(kA, kB, 1.0).orientation.angularDistance(kB.orientation) < 1e-9);
    const Pose third = interpolate(kA, kB, 1.0 / 3);
    const double whole = kA.orientation.angularDistance(kB.orientation);
    CHECK(kA.orientation.angularDistance(third.orientation) == doctest::Approx(whole / 3));
}

TEST_CASE("Euler angles and quaternions undo each other, but at the poles only the sum counts") {
    for (const double azimuth : {-3.0, -1.0, 0.0, 2.0}) {
        for (const double elevation : {-1.5, 0.0, 0.7}) {
            for (const double roll : {-2.5, 0.0, 1.0}) {
                const EulerAngles e = to_euler(to_quaternion({azimuth, elevation, roll}));
                CHECK(e.azimuth == doctest::Approx(azimuth));
                CHECK(e.elevation == doctest::Approx(elevation));
                CHECK(e.roll == doctest::Approx(roll));
            }
        }
    }
    const double pole = std::numbers::pi / 2;
    const Quaternion up = to_quaternion({0.4, pole, 0.1});
    CHECK(to_quaternion(to_euler(up)).angularDistance(up) < 1e-7);
}

TEST_CASE("the columns of the matrix are the manual's direction cosines") {
    const double a = 0.5, e = -0.3, r = 1.1;
    const Matrix3 m = to_quaternion({a, e, r}).toRotationMatrix();
    const Vector3 x(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), -std::sin(e));
    CHECK((m.col(0) - x).norm() < 1e-14);
    CHECK(m(2, 1) == doctest::Approx(std::cos(e) * std::sin(r)));
    CHECK(m(2, 2) == doctest::Approx(std::cos(e) * std::cos(r)));
}
