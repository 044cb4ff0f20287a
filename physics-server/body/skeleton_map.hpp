// Which joint of a captured skeleton moves which segment of ours.
//
// A map is a small text: a line a segment of ours, "left_forearm: LeftForeArm, LeftElbow", with the
// names that joint may have, the first that is there counts; "#" begins a comment. Names are
// compared without capitals, blanks and signs, and without what stands before a colon or before the
// root's own name ("mixamorig:", "Bip01 "). Ready maps are in skeletons/ and built into the
// program; the one that matches most is taken.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/capture.hpp"

namespace percussionist::body {

/// what(): "my.map: line 3: expected 'segment: joint, joint', got '...'"
struct MapError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct SkeletonMap {
    std::string name;
    std::map<std::string, std::vector<std::string>> names;  ///< by segment of ours, or "neck"
};

/// `name` is what errors call the text. Throws MapError, also for a segment that ours has not.
SkeletonMap parse_skeleton_map(std::string_view text, std::string_view name);

/// Those in skeletons/.
const std::vector<SkeletonMap>& ready_skeleton_maps();

/// What a map found: joint indices by segment of ours; those not found are missing.
struct SkeletonMatch {
    std::string map;
    std::map<std::string, int> joints;
};

SkeletonMatch match(const motion::Capture& capture, const SkeletonMap& map);
/// By the ready map that matches most segments; of equals the first.
SkeletonMatch match_best(const motion::Capture& capture);

}  // namespace percussionist::body
