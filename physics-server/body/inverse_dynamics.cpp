#include "body/inverse_dynamics.hpp"

namespace percussionist::body {

namespace {

const Vector3 kGravity(0.0, 0.0, -9.81);

Matrix3 world_inertia(const Segment& s, const Quaternion& orientation) {
    const Matrix3 r = orientation.toRotationMatrix();
    return r * s.inertia.asDiagonal() * r.transpose();
}

}  // namespace

void central_difference(const Skeleton& skeleton, const Placement& before, const Placement& now,
                        const Placement& after, double h, Acceleration& acceleration) {
    using linear::quaternion_log;
    for (int i = 0; i < skeleton.size(); ++i) {
        acceleration.linear[i] = (after.com[i] - 2.0 * now.com[i] + before.com[i]) / (h * h);
        const Vector3 w0 =
            quaternion_log(now.orientation[i] * before.orientation[i].conjugate()) / h;
        const Vector3 w1 =
            quaternion_log(after.orientation[i] * now.orientation[i].conjugate()) / h;
        const Matrix3 inertia = world_inertia(skeleton.segments[i], now.orientation[i]);
        const Vector3 w = 0.5 * (w0 + w1);
        acceleration.momentum[i] = inertia * ((w1 - w0) / h) + w.cross(inertia * w);
    }
}

void joint_torques(const Skeleton& skeleton, const Placement& now, const Acceleration& acceleration,
                   std::vector<Vector3>& torques) {
    for (Vector3& torque : torques) torque.setZero();
    for (int k = 1; k < skeleton.size(); ++k) {
        const Vector3 force = skeleton.segments[k].mass * (acceleration.linear[k] - kGravity);
        for (int j = k; j > 0; j = skeleton.segments[j].parent) {
            torques[j] += (now.com[k] - now.joint[j]).cross(force) + acceleration.momentum[k];
        }
    }
}

TipMass::TipMass(const Skeleton& skeleton, Hand hand) : skeleton_(skeleton), hand_(hand) {
    for (int i = skeleton.stick_index(hand); i > 0; i = skeleton.segments[i].parent) {
        chain_.push_back(i);
    }
    const auto count = 3 * static_cast<Eigen::Index>(chain_.size());
    inertia_.setZero(count, count);
    reach_.setZero(count);
    factors_.compute(Eigen::MatrixXd::Identity(count, count));
}

double TipMass::operator()(const Placement& now, const Vector3& normal,
                           const std::vector<double>& resistance) {
    // Composite of the chain above each joint: mass, centre, inertia about the centre. Joint axes
    // are the world's, so that block (i, j), i the higher, is the inertia of what hangs on i seen
    // from the joints i and j.
    double mass = 0.0;
    Vector3 centre = Vector3::Zero();
    Matrix3 inertia = Matrix3::Zero();
    const auto about = [](double m, const Vector3& a, const Vector3& b) -> Matrix3 {
        return m * (a.dot(b) * Matrix3::Identity() - b * a.transpose());
    };
    const Vector3 tip = now.tip(skeleton_, hand_);
    for (std::size_t i = 0; i < chain_.size(); ++i) {
        const int segment = chain_[i];
        const Segment& s = skeleton_.segments[segment];
        const Vector3 merged = (mass * centre + s.mass * now.com[segment]) / (mass + s.mass);
        const Vector3 d0 = centre - merged;
        const Vector3 d1 = now.com[segment] - merged;
        inertia += about(mass, d0, d0) + world_inertia(s, now.orientation[segment]) +
                   about(s.mass, d1, d1);
        mass += s.mass;
        centre = merged;
        const auto row = static_cast<Eigen::Index>(3 * i);
        const Vector3 arm = centre - now.joint[segment];
        for (std::size_t j = i; j < chain_.size(); ++j) {
            const auto column = static_cast<Eigen::Index>(3 * j);
            const Vector3 other = centre - now.joint[chain_[j]];
            const Matrix3 block = inertia + about(mass, arm, other);
            inertia_.block<3, 3>(row, column) = block;
            inertia_.block<3, 3>(column, row) = block.transpose();
        }
        inertia_.block<3, 3>(row, row) += resistance[segment] * Matrix3::Identity();
        reach_.segment<3>(row) = (tip - now.joint[segment]).cross(normal);
    }
    factors_.compute(inertia_);
    return 1.0 / reach_.dot(factors_.solve(reach_));
}

}  // namespace percussionist::body
