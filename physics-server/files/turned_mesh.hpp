// Meshes turned on a lathe: an outline goes round an axis. What limbs, sticks and drums are made
// of.
//
// An outline is walked upwards along z on its outer side; its normals are smooth along it, so that
// a sharp edge is where one outline ends and the next begins. Triangles are counter-clockwise seen
// from outside. Pure functions over values.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "core/linear/rotation.hpp"

namespace percussionist::files {

struct Mesh {
    std::vector<linear::Vector3> points;   ///< [m]
    std::vector<linear::Vector3> normals;  ///< unit, one a point
    std::vector<std::uint32_t> triangles;  ///< three points each
};

struct OutlinePoint {
    double radius = 0.0;  ///< [m]
    double height = 0.0;  ///< along the axis [m]
};
using Outline = std::vector<OutlinePoint>;

/// An outline whose last point is its first is closed, a ring. Throws std::invalid_argument for one
/// of fewer than two points, a negative radius, or fewer than three slices.
Mesh turned(const Outline& outline, int slices);

/// The quarter turns of a ball's outline, and all of one.
Outline ball(double radius, double height, int rings = 12);
/// A curve through the points (Catmull-Rom), `steps` points for each of theirs.
Outline smooth(const Outline& through, int steps = 4);

/// Moved, turned and stretched, also unevenly; normals stay normals.
Mesh transformed(const Mesh& mesh, const Eigen::Affine3d& by);
void append(Mesh& to, const Mesh& more);

}  // namespace percussionist::files
