#include "files/turned_mesh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

using namespace percussionist::files;
using percussionist::linear::Vector3;

namespace {

/// By the divergence theorem; positive where triangles are counter-clockwise from outside.
double volume(const Mesh& m) {
    double sum = 0.0;
    for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
        const Vector3 &a = m.points[m.triangles[i]], &b = m.points[m.triangles[i + 1]],
                      &c = m.points[m.triangles[i + 2]];
        sum += a.dot(b.cross(c)) / 6.0;
    }
    return sum;
}

bool faces_along_normals(const Mesh& m) {
    for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
        const Vector3 &a = m.points[m.triangles[i]], &b = m.points[m.triangles[i + 1]],
                      &c = m.points[m.triangles[i + 2]];
        Vector3 mean = Vector3::Zero();
        for (int k = 0; k < 3; ++k) mean += m.normals[m.triangles[i + k]];
        if ((b - a).cross(c - a).dot(mean) <= 0.0) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a turned ball has a ball's volume and its points' directions for normals") {
    const Mesh m = turned(ball(0.5, 1.0, 64), 128);
    CHECK(volume(m) == doctest::Approx(4.0 / 3.0 * std::numbers::pi * 0.125).epsilon(0.002));
    double worst = 0.0;
    for (std::size_t i = 0; i < m.points.size(); ++i) {
        const Vector3 direction = (m.points[i] - Vector3::UnitZ()).normalized();
        worst = std::max(worst, (direction - m.normals[i]).norm());
    }
    CHECK(worst < 0.05);
    CHECK(faces_along_normals(m));
}

TEST_CASE("a ring that closes is a torus") {
    Outline outline;
    for (int i = 0; i <= 48; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % 48) / 48.0;
        outline.push_back({1.0 + 0.2 * std::cos(angle), 0.2 * std::sin(angle)});
    }
    const Mesh m = turned(outline, 96);
    CHECK(volume(m) == doctest::Approx(2.0 * std::pow(std::numbers::pi, 2) * 0.04).epsilon(0.01));
    CHECK(faces_along_normals(m));
}

TEST_CASE("uneven stretching keeps normals at right angles to the surface") {
    const Eigen::Affine3d stretch(Eigen::Scaling(Vector3(1.0, 0.3, 2.0)));
    const Mesh m = transformed(turned(ball(1.0, 0.0, 64), 64), stretch);
    CHECK(volume(m) == doctest::Approx(0.6 * 4.0 / 3.0 * std::numbers::pi).epsilon(0.005));
    double worst = 0.0;
    for (std::size_t i = 0; i < m.points.size(); ++i) {
        const Vector3& p = m.points[i];
        const Vector3 gradient = Vector3(p.x(), p.y() / 0.09, p.z() / 4.0).normalized();
        worst = std::max(worst, (gradient - m.normals[i]).norm());
    }
    CHECK(worst < 0.05);
}

TEST_CASE("a smooth outline goes through its points and nowhere below the axis") {
    const Outline through{{0, 0}, {1, 0.1}, {0.05, 0.5}, {0, 1}};
    const Outline o = smooth(through, 5);
    REQUIRE(o.size() == 16);
    for (std::size_t i = 0; i < through.size(); ++i) {
        CHECK(o[5 * i].radius == doctest::Approx(through[i].radius));
        CHECK(o[5 * i].height == doctest::Approx(through[i].height));
    }
    for (const OutlinePoint& p : o) CHECK(p.radius >= 0.0);
    CHECK_THROWS_AS(turned({{1, 0}}, 8), std::invalid_argument);
    CHECK_THROWS_AS(turned({{1, 0}, {-1, 1}}, 8), std::invalid_argument);
    CHECK_THROWS_AS(turned({{1, 0}, {1, 1}}, 2), std::invalid_argument);
}
