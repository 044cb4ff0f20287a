// A drummer at a kit as a drawing (SVG): from the front and from above, side by side.
#pragma once

#include <string>
#include <vector>

#include "body/kit_animation.hpp"

namespace percussionist::app {

std::string kit_picture(const score::Kit& kit, const body::Skeleton& skeleton,
                        const body::Placement& placement,
                        const std::vector<body::ObjectState>& states, const std::string& title);

}  // namespace percussionist::app
