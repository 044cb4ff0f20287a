// A body as what is told of it: values of body/ become messages. Pure functions; times [s] are the
// caller's.
#pragma once

#include <array>
#include <cstddef>

#include "body/posture.hpp"
#include "body/touch.hpp"
#include "osc/outgoing.hpp"

namespace percussionist::app {

// How often a running server tells them [s].
constexpr double kPoseInterval = 1.0 / 60.0;
constexpr double kStatusInterval = 1.0;

/// The first N of a vector, and a rotation as w x y z, as they go over the wire.
template <std::size_t N>
std::array<float, N> floats(const linear::Vector3& v) {
    std::array<float, N> out{};
    for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<float>(v[static_cast<int>(i)]);
    return out;
}
inline std::array<float, 4> floats(const linear::Quaternion& q) {
    return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
            static_cast<float>(q.z())};
}

/// What was felt where something was struck, into a contact's message.
void put_touch(const body::Touch& touch, osc::ContactMessage& message);

osc::PoseMessage pose_message(double time, const body::Skeleton& skeleton,
                              const body::Placement& placement);
/// Its segments; no drum.
osc::SceneMessage scene_message(double time, const body::Skeleton& skeleton);

}  // namespace percussionist::app
