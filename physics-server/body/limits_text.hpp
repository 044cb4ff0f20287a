// Joint limits as a text: a line a joint,
//     left_forearm euler LOW_Z HIGH_Z LOW_Y HIGH_Y LOW_X HIGH_X
//     left_forearm quaternion MEAN_W X Y Z  AXES (9, by rows)  SEMI_AXES (3)
// by segment; angles in degrees, the mean as a unit quaternion; "#" begins a comment.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "body/joint_limits.hpp"

namespace percussionist::body {

/// what(): "my.limits: line 3: expected ..., got '...'"
struct LimitsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

using LimitsBySegment = std::map<std::string, JointLimits>;

std::string limits_text(const LimitsBySegment& limits);

/// `name` is what errors call the text. Throws LimitsError.
LimitsBySegment parse_limits(std::string_view text, std::string_view name);

}  // namespace percussionist::body
