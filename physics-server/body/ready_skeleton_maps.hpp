// The maps of skeletons/, built into the program by CMake.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace percussionist::body {

/// Name and text of each.
extern const std::vector<std::pair<std::string_view, std::string_view>> kReadySkeletonMaps;

}  // namespace percussionist::body
