#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "body/limits_from_motion.hpp"
#include "body/limits_text.hpp"
#include "body/posture.hpp"

using namespace percussionist;
using body::Quaternion;
using body::Vector3;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A hinge about y that also twists a little about x, signs of quaternions at random.
std::vector<Quaternion> hinge() {
    std::mt19937 random(3);
    std::vector<Quaternion> all;
    for (int i = 0; i < 4000; ++i) {
        const double bend = 60.0 * kDegree * std::sin(0.01 * i);
        const double twist = 4.0 * kDegree * std::sin(0.037 * i);
        Quaternion q =
            body::from_euler_zyx({0.3, 0.0, 0.0}) * linear::quaternion_exp({twist, bend, 0.0});
        if (random() % 2 == 0) q.coeffs() *= -1.0;
        all.push_back(q);
    }
    return all;
}

}  // namespace

TEST_CASE("an ellipsoid lets its motion through and little else; a box lets through more") {
    const auto seen = hinge();
    const body::JointLimits ellipsoid = body::ellipsoid_limits(seen);
    int inside = 0;
    for (const Quaternion& q : seen) {
        if (body::ellipsoid_distance(q, ellipsoid) <= 1.0) ++inside;
    }
    CHECK(inside == static_cast<int>(seen.size()));  // what it was learnt from it admits
    const double small = body::admitted_share(ellipsoid, 200000);
    CHECK(small < 0.003);
    CHECK(body::admitted_share(body::euler_limits(seen), 200000) > small);
}

TEST_CASE("a box admits all that it was learnt from") {
    const auto seen = hinge();
    const body::JointLimits box = body::euler_limits(seen);
    for (const Quaternion& q : seen) CHECK(body::clamp(q, box).angularDistance(q) < 1e-9);
}

TEST_CASE("one frame in T-pose among many does not widen the ellipsoid") {
    auto seen = hinge();
    const Vector3 before = body::ellipsoid_limits(seen).semi_axes;
    seen.front() = linear::quaternion_exp({0.0, 0.0, 2.5});
    const Vector3 after = body::ellipsoid_limits(seen).semi_axes;
    CHECK(after.maxCoeff() < 1.1 * before.maxCoeff());
}

TEST_CASE("what lies outside comes to the surface, and stays there") {
    const body::JointLimits limits = body::ellipsoid_limits(hinge());
    const Quaternion out = linear::quaternion_exp({1.0, 1.5, -1.0});
    const Quaternion in = body::clamp(out, limits);
    CHECK(body::ellipsoid_distance(in, limits) == doctest::Approx(1.0));
    CHECK(body::clamp(limits.mean, limits).coeffs() == limits.mean.coeffs());
}

TEST_CASE("limits written and read again are the same") {
    body::LimitsBySegment all;
    all["left_hand"] = body::ellipsoid_limits(hinge());
    all["head"] = body::euler_limits(hinge());
    const auto again = body::parse_limits(body::limits_text(all), "x.limits");
    CHECK((again.at("left_hand").semi_axes - all["left_hand"].semi_axes).norm() < 1e-7);
    CHECK((again.at("head").upper_zyx - all["head"].upper_zyx).norm() < 1e-7);
    CHECK_THROWS_WITH(body::parse_limits("head euler 1 2 3\n", "x.limits"),
                      "x.limits: line 1: expected 6 numbers after euler, got 'head euler 1 2 3'");
}
