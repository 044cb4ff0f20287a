#include "body/captured_pose.hpp"

namespace percussionist::body {

namespace {

std::optional<Vector3> unless_zero(const Vector3& v) {
    constexpr double kNothing = 1e-6;
    if (!(v.norm() > kNothing)) return std::nullopt;
    return v;
}

}  // namespace

void CapturedPose::take(std::size_t frame) {
    for (std::size_t j = 0; j < capture_.joints.size(); ++j) {
        const motion::CapturedJoint& joint = capture_.joints[j];
        turn_[j] = capture_.rotation(frame, j);
        place_[j] = joint.offset;
        if (joint.parent < 0) continue;
        place_[j] = place_[joint.parent] + turn_[joint.parent] * joint.offset;
        turn_[j] = (turn_[joint.parent] * turn_[j]).normalized();
    }
}

int CapturedPose::joint(const std::string& segment) const {
    const auto found = match_.joints.find(segment);
    return found == match_.joints.end() ? -1 : found->second;
}

std::optional<Vector3> CapturedPose::line(const std::string& from, const std::string& to) const {
    const int a = joint(from);
    const int b = joint(to);
    if (a < 0 || b < 0) return std::nullopt;
    return unless_zero(place_[b] - place_[a]);
}

std::optional<Vector3> CapturedPose::to_children(const std::string& segment) const {
    const int parent = joint(segment);
    if (parent < 0) return std::nullopt;
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (std::size_t j = 0; j < capture_.joints.size(); ++j) {
        if (capture_.joints[j].parent != parent) continue;
        sum += place_[j] - place_[parent];
        ++count;
    }
    if (count == 0) return std::nullopt;
    return unless_zero(sum / count);
}

}  // namespace percussionist::body
