#include "app/gltf_motion.hpp"

#include "app/figure.hpp"

namespace percussionist::app {

GltfMotion::GltfMotion(const body::Skeleton& skeleton, const linear::Vector3& head_centre,
                       double drum_radius)
    : skeleton_(skeleton) {
    scene_.nodes = figure_nodes(skeleton);
    scene_.turning = scene_.nodes.size();
    scene_.nodes.push_back(drum_node(head_centre, drum_radius));
}

void GltfMotion::add(double time, const body::Placement& placement) {
    scene_.times.push_back(time);
    scene_.moved.push_back(placement.joint[0].cast<float>());
    for (int i = 0; i < skeleton_.size(); ++i) {
        const int parent = skeleton_.segments[i].parent;
        const body::Quaternion& own = placement.orientation[i];
        const body::Quaternion turn =
            parent < 0 ? own : placement.orientation[parent].conjugate() * own;
        scene_.rotations.push_back(turn.cast<float>());
    }
}

}  // namespace percussionist::app
