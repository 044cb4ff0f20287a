// Motion and what moves as glTF 2.0, in one binary file (.glb): Blender and other programs open it.
//
// Nodes form a tree; the first few of them turn about their own place, frame by frame, and the
// first one, and those that `shifted` names, move as well. Our world (x to the front, y to the
// left, z up) becomes glTF's (z to the front, x to the left, y up), which is a change of names and
// of no number; metres and seconds stay. Colours are given as seen (sRGB) and written as light
// (linear).
//
// Source: Khronos, "glTF 2.0 Specification", the parts of the same names.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "files/turned_mesh.hpp"

namespace percussionist::files {

struct Paint {
    std::string name;                     ///< of the material; the same name, the same paint
    std::array<double, 3> colour{};       ///< sRGB, 0..1
    double roughness = 0.8, metal = 0.0;  ///< 0..1
};

struct PaintedMesh {
    Paint paint;
    Mesh mesh;
};

struct SceneNode {
    std::string name;
    int parent = -1;                                  ///< below this node's own; -1: the world
    linear::Vector3 place = linear::Vector3::Zero();  ///< in the parent's frame [m]
    std::vector<PaintedMesh> looks;                   ///< in the node's own frame
};

struct MovingScene {
    std::vector<SceneNode> nodes;
    std::size_t turning = 0;                    ///< the first so many nodes have rotations
    std::vector<double> times;                  ///< of the frames, growing [s]
    std::vector<Eigen::Quaternionf> rotations;  ///< against the parent; `turning` for each frame
    std::vector<Eigen::Vector3f> moved;         ///< place of the first node, for each frame [m]
    /// Of other nodes that move: the place in the parent's frame, for each frame [m].
    std::map<std::size_t, std::vector<Eigen::Vector3f>> shifted;
};

/// The bytes of a .glb. The same scene gives the same bytes. Throws std::invalid_argument where
/// parents, times or counts do not fit together, and std::length_error above 4 GB.
std::vector<char> glb(const MovingScene& scene);

/// Throws std::runtime_error naming the file if it cannot be written.
void write_glb(const std::filesystem::path& path, const MovingScene& scene);

}  // namespace percussionist::files
