#include "body/clip.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace percussionist::body {

namespace {

constexpr std::size_t kNumbers = 4;  // a quaternion's
/// A clip glides to rest with this time constant [s].
constexpr double kGlide = 0.05;

/// The time at which to read a curve that lasts from 0 to `end`.
double gliding(double t, double end) {
    if (t < 0.0) return -kGlide * (1.0 - std::exp(t / kGlide));
    if (t > end) return end + kGlide * (1.0 - std::exp((end - t) / kGlide));
    return t;
}

}  // namespace

Quaternion mean_rotation(const std::vector<Quaternion>& rotations) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const Quaternion& q : rotations) sum += q.coeffs() * q.coeffs().transpose();
    if (rotations.empty()) return Quaternion::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(sum);
    Quaternion mean(Eigen::Vector4d(solver.eigenvectors().col(3)));
    if (mean.w() < 0.0) mean.coeffs() *= -1.0;
    return mean.normalized();
}

Clip::Clip(std::string name, const Skeleton& skeleton, const std::vector<Posture>& postures,
           double frame_time)
    : name_(std::move(name)), mean_(skeleton) {
    const std::size_t joints = skeleton.segments.size();
    std::vector<double> times;
    std::vector<double> values;
    for (std::size_t f = 0; f < postures.size(); ++f) {
        times.push_back(static_cast<double>(f) * frame_time);
        for (const Quaternion& q : postures[f].joints) {
            for (const double c : {q.w(), q.x(), q.y(), q.z()}) values.push_back(c);
        }
    }
    joints_ = Spline(std::move(times), std::move(values), kNumbers * joints);
    std::vector<Quaternion> series(postures.size());
    for (std::size_t j = 0; j < joints; ++j) {
        for (std::size_t f = 0; f < postures.size(); ++f) series[f] = postures[f].joints[j];
        mean_.joints[j] = mean_rotation(series);
    }
}

void Clip::posture(double t, Posture& posture) const {
    constexpr std::size_t kMostJoints = 32;
    std::array<double, kNumbers * kMostJoints> values{};
    joints_.at(gliding(t, duration()), values);
    for (std::size_t j = 0; j < posture.joints.size(); ++j) {
        const double* v = values.data() + kNumbers * j;
        posture.joints[j] = Quaternion(v[0], v[1], v[2], v[3]).normalized();
    }
}

Vector3 Clip::own_tip(double t, Hand hand) const {
    Vector3 tip = Vector3::Zero();
    tips_[static_cast<int>(hand)].at(gliding(t, duration()), std::span(tip.data(), 3));
    return tip;
}

}  // namespace percussionist::body
