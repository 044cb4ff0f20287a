#include "core/linear/rotation.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace percussionist::linear;

TEST_CASE("log undoes exp for every angle below pi") {
    for (const double angle : {0.0, 1e-12, 1e-6, 0.3, 1.5, 3.1}) {
        const Vector3 r = angle * Vector3(1.0, -2.0, 0.5).normalized();
        CHECK((quaternion_log(quaternion_exp(r)) - r).norm() == doctest::Approx(0).epsilon(1e-12));
    }
}

TEST_CASE("a quaternion and its negative have the same rotation vector") {
    const Quaternion q = quaternion_exp({0.2, 1.0, -0.7});
    const Quaternion negative(-q.w(), -q.x(), -q.y(), -q.z());
    CHECK((quaternion_log(q) - quaternion_log(negative)).norm() < 1e-15);
}

TEST_CASE("a quarter turn about z takes x to y") {
    const Quaternion q = quaternion_exp({0.0, 0.0, std::numbers::pi / 2});
    CHECK((q * Vector3::UnitX() - Vector3::UnitY()).norm() < 1e-15);
}
