// What the percussionist and the drum look like: meshes about the skeleton, for files of pictures
// and motion. Nothing is simulated with them.
#pragma once

#include "body/skeleton.hpp"
#include "files/gltf_file.hpp"

namespace percussionist::app {

/// A node a segment, in the skeleton's order: its origin in its joint, its axes the world's at
/// rest.
std::vector<files::SceneNode> figure_nodes(const body::Skeleton& skeleton);

/// A drum on its stand; `head_centre` and the floor below it in the world [m].
files::SceneNode drum_node(const linear::Vector3& head_centre, double radius);

}  // namespace percussionist::app
