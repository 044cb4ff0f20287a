// Recorded paths of sticks, made a motion of our body: mended, moved in front of it, and given
// postures.
//
// Recordings have an origin and a direction of their own. Where a stick strikes (the middle of its
// lowest tenth) comes to where the body strikes; if both sticks were recorded, 5 to 60 cm apart,
// they are turned about the vertical so that the left one is to the left. A stick that was not
// recorded waits.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "body/clip.hpp"

namespace percussionist::body {

struct StickPlaces {
    double height = 0.93;  ///< of the middle of a tip that strikes [m]
    double apart = 0.16;   ///< of the two places [m]
};

struct StickMotion {
    std::shared_ptr<const Clip> clip;
    double frame_time = 0.0;   ///< of the recording, the median [s]
    double worst_reach = 0.0;  ///< farthest that the body's own tips stay from those recorded [m]
    std::vector<std::string> remarks;  ///< repairs
};

/// By Hand; at least one of them. Throws std::invalid_argument if nothing is left of a path.
StickMotion follow_sticks(const std::string& name, const Skeleton& skeleton,
                          std::array<std::optional<motion::Trajectory>, 2> paths,
                          const StickPlaces& places = {});

}  // namespace percussionist::body
