// Vectors, matrices, rotations and poses as objects of Pd: one table, a row for each object.
#pragma once

#include <span>
#include <string>

namespace percussionist::objects {

/// Makes the object of that name known to Pd.
void add_matrix_object(const char* name);

std::span<const std::string> matrix_object_names();

}  // namespace percussionist::objects
