#include "core/listening/linear_prediction.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace percussionist::listening;

namespace {

std::vector<double> ringing(std::size_t size) {
    std::vector<double> x(size);
    for (std::size_t n = 0; n < size; ++n) {
        for (int k = 1; k <= 5; ++k) {
            x[n] += std::exp(-0.001 * k * static_cast<double>(n)) *
                    std::sin(0.11 * k * static_cast<double>(n) + k);
        }
    }
    return x;
}

double energy(const std::vector<double>& x) {
    double sum = 0.0;
    for (const double value : x) {
        sum += value * value;
    }
    return sum;
}

}  // namespace

TEST_CASE("decaying partials are predicted from their past, also where it was not learnt") {
    const auto x = ringing(1000);
    const auto a = predictor(x, 100, 500);
    CHECK(energy(residual(x, a, 500, 1000)) < 1e-8 * energy({x.begin() + 500, x.end()}));
}

TEST_CASE("what the past does not explain is left") {
    auto x = ringing(1000);
    const auto a = predictor(x, 100, 500);
    x[700] += 0.01;
    const auto rest = residual(x, a, 600, 800);
    CHECK(rest[100] == doctest::Approx(0.01).epsilon(0.01));
}

TEST_CASE("noise stays as it is, and silence silent") {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> noise(4000);
    for (double& x : noise) {
        x = normal(random);
    }
    const auto a = predictor(noise, 0, 2000);
    const double ratio = energy(residual(noise, a, 2000, 4000)) / 2000;
    CHECK(ratio == doctest::Approx(1.0).epsilon(0.1));
    const std::vector<double> silence(500, 0.0);
    CHECK(energy(residual(silence, predictor(silence, 0, 400), 0, 500)) == 0.0);
    CHECK(predictor(silence, 0, 0).size() == kPredictionOrder);
}
