// A captured skeleton in one frame: where its joints are and how they are turned, and the lines of
// anatomy through them. Lengths in the file's unit, axes of the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "body/skeleton_map.hpp"

namespace percussionist::body {

using linear::Quaternion;
using linear::Vector3;

class CapturedPose {
  public:
    CapturedPose(const motion::Capture& capture, const SkeletonMatch& match)
        : capture_(capture),
          match_(match),
          place_(capture.joints.size(), Vector3::Zero()),
          turn_(capture.joints.size(), Quaternion::Identity()) {}

    void take(std::size_t frame);

    /// The joint of a segment of ours; -1: not matched.
    [[nodiscard]] int joint(const std::string& segment) const;
    [[nodiscard]] const Quaternion& turn(int joint) const { return turn_[joint]; }

    /// From the joint of one segment to that of another; nothing if either is not matched or both
    /// are in the same place.
    [[nodiscard]] std::optional<Vector3> line(const std::string& from, const std::string& to) const;
    /// From a segment's joint to the mean of those that hang on it; nothing if none does.
    [[nodiscard]] std::optional<Vector3> to_children(const std::string& segment) const;

  private:
    const motion::Capture& capture_;
    const SkeletonMatch& match_;
    std::vector<Vector3> place_;
    std::vector<Quaternion> turn_;
};

}  // namespace percussionist::body
