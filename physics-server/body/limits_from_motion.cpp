#include "body/limits_from_motion.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "body/clip.hpp"
#include "body/posture.hpp"

namespace percussionist::body {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kWider = 1.05;
constexpr double kLeastDeviation = kDegree;
constexpr double kLongestSemiAxis = 3.1;

/// The largest of a series, where a frame that stands alone (a T-pose, a marker lost) counts no
/// more than the larger of its neighbours.
double largest_of_many(const std::vector<double>& values) {
    double most = -1e9;
    for (std::size_t i = 0; i < values.size(); ++i) {
        double beside = values.size() == 1 ? values[i] : -1e9;
        if (i > 0) beside = std::max(beside, values[i - 1]);
        if (i + 1 < values.size()) beside = std::max(beside, values[i + 1]);
        most = std::max(most, std::min(values[i], beside));
    }
    return most;
}

/// Euler angles z y x over time, made continuous.
std::vector<Vector3> angles_of(const std::vector<Quaternion>& rotations) {
    if (rotations.empty())
        throw std::invalid_argument("joint limits: expected rotations, got none");
    std::vector<Vector3> all;
    for (const Quaternion& q : rotations) {
        Vector3 angles = euler_zyx(q);
        for (int a = 0; a < 3 && !all.empty(); ++a) {
            angles[a] =
                all.back()[a] + std::remainder(angles[a] - all.back()[a], 2.0 * std::numbers::pi);
        }
        all.push_back(angles);
    }
    return all;
}

}  // namespace

JointLimits euler_limits(const std::vector<Quaternion>& rotations) {
    const std::vector<Vector3> angles = angles_of(rotations);
    JointLimits limits;
    for (int a = 0; a < 3; ++a) {
        std::vector<double> values;
        for (const Vector3& v : angles) values.push_back(v[a]);
        const double high = largest_of_many(values);
        for (double& value : values) value = -value;
        const double low = -largest_of_many(values);
        const double half = std::max(0.5 * kWider * (high - low), kLeastDeviation);
        // Beyond half a turn an angle says nothing: it wraps.
        const double middle = 0.5 * (low + high);
        limits.lower_zyx[a] = std::max(middle - half, -std::numbers::pi);
        limits.upper_zyx[a] = std::min(middle + half, std::numbers::pi);
    }
    return limits;
}

JointLimits ellipsoid_limits(const std::vector<Quaternion>& rotations) {
    if (rotations.empty())
        throw std::invalid_argument("joint limits: expected rotations, got none");
    JointLimits limits;
    limits.shape = LimitShape::ellipsoid;
    limits.mean = mean_rotation(rotations);
    const auto n = static_cast<Eigen::Index>(rotations.size());
    Eigen::MatrixX3d tangent(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        // The logarithm takes q and -q for the same, which is the flip of signs.
        tangent.row(i) = linear::quaternion_log(limits.mean.conjugate() * rotations[i]).transpose();
    }
    // The right singular vectors of all v, and their singular values squared.
    const Eigen::SelfAdjointEigenSolver<Matrix3> svd(
        Matrix3(tangent.transpose() * tangent / static_cast<double>(n)));
    limits.axes = svd.eigenvectors();
    const Vector3 deviations = svd.eigenvalues()
                                   .cwiseMax(Vector3::Zero())
                                   .cwiseSqrt()
                                   .cwiseMax(Vector3::Constant(kLeastDeviation));
    std::vector<double> distances;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Vector3 v = tangent.row(i).transpose();
        distances.push_back((limits.axes.transpose() * v).cwiseQuotient(deviations).norm());
    }
    const double k = std::max(kWider * largest_of_many(distances), 1.0);
    limits.semi_axes = (k * deviations).cwiseMin(Vector3::Constant(kLongestSemiAxis));
    return limits;
}

JointLimits widened(const JointLimits& box, const std::vector<Quaternion>& rotations) {
    JointLimits limits = box;
    constexpr double kMargin = 5.0 * kDegree;
    for (const Quaternion& q : rotations) {
        const Vector3 angles = euler_zyx(q);
        limits.lower_zyx = limits.lower_zyx.cwiseMin(angles - Vector3::Constant(kMargin));
        limits.upper_zyx = limits.upper_zyx.cwiseMax(angles + Vector3::Constant(kMargin));
    }
    return limits;
}

double admitted_share(const JointLimits& limits, int samples) {
    std::mt19937 random(1);
    const auto one = [&] { return static_cast<double>(random()) / 4294967295.0; };
    int inside = 0;
    for (int i = 0; i < samples; ++i) {
        // Uniform over all rotations: Shoemake 1992.
        const double u = one();
        const double a = 2.0 * std::numbers::pi * one();
        const double b = 2.0 * std::numbers::pi * one();
        const Quaternion q(std::sqrt(u) * std::cos(b), std::sqrt(1.0 - u) * std::sin(a),
                           std::sqrt(1.0 - u) * std::cos(a), std::sqrt(u) * std::sin(b));
        if (clamp(q, limits).coeffs() == q.coeffs()) ++inside;
    }
    return static_cast<double>(inside) / samples;
}

}  // namespace percussionist::body
