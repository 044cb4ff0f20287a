#include "app/body_messages.hpp"

namespace percussionist::app {

void put_touch(const body::Touch& touch, osc::ContactMessage& m) {
    m.wall = m.instant = touch.instant;
    m.place = floats<2>(touch.place);
    m.velocity = floats<3>(touch.velocity);
    m.force = floats<3>(touch.peak_force);
    m.impulse = static_cast<float>(touch.impulse);
    m.duration = static_cast<float>(touch.duration);
    m.mass = static_cast<float>(touch.effective_mass);
}

osc::PoseMessage pose_message(double time, const body::Skeleton& skeleton,
                              const body::Placement& placement) {
    osc::PoseMessage pose;
    pose.wall = time;
    for (int i = 0; i < skeleton.size(); ++i) {
        pose.bodies.push_back({skeleton.segments[i].name, floats<3>(placement.com[i]),
                               floats(placement.orientation[i])});
    }
    return pose;
}

osc::SceneMessage scene_message(double time, const body::Skeleton& skeleton) {
    osc::SceneMessage scene;
    scene.wall = time;
    for (const body::Segment& s : skeleton.segments) {
        const linear::Vector3 middle = 0.5 * (s.joint_rest + s.end_rest) - s.com_rest;
        scene.bodies.push_back({s.name, floats<3>(middle), floats<3>(s.size)});
    }
    return scene;
}

}  // namespace percussionist::app
