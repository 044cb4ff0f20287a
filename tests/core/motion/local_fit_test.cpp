#include "core/motion/local_fit.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace percussionist::motion;

namespace {

Vector3 cubic(double t) {
    return {1 + 2 * t - 3 * t * t + 4 * t * t * t, -t, 0.5 * t * t};
}

}  // namespace

TEST_CASE("of a cubic the fit knows every derivative, however uneven the times") {
    std::vector<PathPoint> points;
    for (const double t : {10.0, 10.011, 10.015, 10.03, 10.05}) {
        points.push_back({t, cubic(t - 10)});
    }
    const LocalFit fit(points, 3, 10.02);
    const double t = 0.04;
    CHECK((fit.position(10 + t) - cubic(t)).norm() < 1e-9);
    CHECK(fit.velocity(10 + t).x() == doctest::Approx(2 - 6 * t + 12 * t * t));
    CHECK(fit.acceleration(10 + t).x() == doctest::Approx(-6 + 24 * t));
    CHECK(fit.jerk().x() == doctest::Approx(24).epsilon(1e-4));
    CHECK(fit.acceleration(10 + t).z() == doctest::Approx(1).epsilon(1e-6));
    CHECK(fit.residual() < 1e-9);
}

TEST_CASE("with fewer points it is a curve of less degree; with none it stands still") {
    const std::vector<PathPoint> two = {{0.0, {0, 0, 0}}, {0.5, {1, 0, 0}}};
    CHECK(LocalFit(two, 3, 0.0).velocity(0.2).x() == doctest::Approx(2));
    CHECK(LocalFit(two, 3, 0.0).acceleration(0.2).norm() == 0);
    CHECK(LocalFit({}, 2, 0.0).position(1.0).norm() == 0);
}

TEST_CASE("noise in the velocity is what theory says, and far less than that of a difference") {
    std::mt19937 random(4);
    std::normal_distribution<> noise(0.0, 3e-4);
    constexpr int kPoints = 7;
    constexpr double kStep = 1 / 120.0;
    double squares = 0.0;
    constexpr int kRuns = 2000;
    for (int run = 0; run < kRuns; ++run) {
        std::vector<PathPoint> points;
        for (int i = 0; i < kPoints; ++i) {
            points.push_back({i * kStep, {noise(random), 0, 0}});
        }
        const double v = LocalFit(points, 2, 3 * kStep).velocity(3 * kStep).x();
        squares += v * v / kRuns;
    }
    const double theory = 3e-4 / kStep * std::sqrt(12.0 / (kPoints * (kPoints * kPoints - 1)));
    CHECK(std::sqrt(squares) == doctest::Approx(theory).epsilon(0.1));
    CHECK(std::sqrt(squares) < 0.2 * 3e-4 * std::sqrt(2.0) / kStep);
}

TEST_CASE("the residual is the noise") {
    std::mt19937 random(4);
    std::normal_distribution<> noise(0.0, 1e-3);
    double squares = 0.0;
    for (int run = 0; run < 500; ++run) {
        std::vector<PathPoint> points;
        for (int i = 0; i < 9; ++i) {
            points.push_back(
                {0.01 * i, cubic(0.01 * i) + Vector3(noise(random), noise(random), noise(random))});
        }
        const double r = LocalFit(points, 3, 0.0).residual();
        squares += r * r / 500;
    }
    CHECK(std::sqrt(squares) == doctest::Approx(1e-3).epsilon(0.05));
}
