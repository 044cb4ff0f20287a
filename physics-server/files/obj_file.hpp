// A mesh as a Wavefront OBJ file, which Gem's [model] and most programs read.
#pragma once

#include <string>

#include "files/turned_mesh.hpp"

namespace percussionist::files {

/// Points, normals and triangles as text, to four digits behind the point.
std::string obj(const Mesh& mesh);

}  // namespace percussionist::files
