#include "core/motion/local_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace percussionist::motion {

namespace {

using Normal = Eigen::Matrix4d;
using RightSide = Eigen::Matrix<double, 4, 3>;

}  // namespace

LocalFit::LocalFit(std::span<const PathPoint> points, int degree, double origin) noexcept
    : origin_(origin) {
    if (points.empty()) {
        return;
    }
    const int terms = std::clamp(std::min(degree + 1, static_cast<int>(points.size())), 1, 4);
    // Times in units of the points' span, or the normal equations lose digits.
    double span = 1e-9;
    for (const PathPoint& point : points) {
        span = std::max(span, std::abs(point.time - origin));
    }
    Normal normal = Normal::Identity();
    normal.topLeftCorner(terms, terms).setZero();
    RightSide right = RightSide::Zero();
    for (const PathPoint& point : points) {
        Eigen::Vector4d powers = Eigen::Vector4d::Zero();
        double power = 1.0;
        for (int i = 0; i < terms; ++i) {
            powers[i] = power;
            power *= (point.time - origin) / span;
        }
        normal += powers * powers.transpose();
        right += powers * point.position.transpose();
    }
    const RightSide solution = normal.ldlt().solve(right);
    double scale = 1.0;
    for (int i = 0; i < terms; ++i) {
        coefficients_[static_cast<std::size_t>(i)] = solution.row(i).transpose() / scale;
        scale *= span;
    }
    const int freedom = static_cast<int>(points.size()) - terms;
    double squares = 0.0;
    for (const PathPoint& point : points) {
        squares += (point.position - position(point.time)).squaredNorm();
    }
    residual_ = freedom > 0 ? std::sqrt(squares / (3 * freedom)) : 0.0;
}

Vector3 LocalFit::derivative(int order, double time) const noexcept {
    const double t = time - origin_;
    Vector3 sum = Vector3::Zero();
    for (int i = 3; i >= order; --i) {
        double factor = 1.0;
        for (int k = 0; k < order; ++k) {
            factor *= i - k;
        }
        sum = sum * t + factor * coefficients_[static_cast<std::size_t>(i)];
    }
    return sum;
}

}  // namespace percussionist::motion
