// The first half of a BVH file: the tree of joints and the channels of each.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/capture.hpp"
#include "files/text_lines.hpp"

namespace percussionist::files {

/// A channel: x, y or z of a joint's position or rotation.
struct BvhChannel {
    bool rotation = false;
    int axis = 0;
};

struct BvhHierarchy {
    std::vector<motion::CapturedJoint> joints;
    std::vector<std::vector<BvhChannel>> channels;  ///< by joint, in the file's order
    std::size_t channel_count = 0;
};

/// Reads from HIERARCHY to MOTION. Throws BvhError.
BvhHierarchy read_bvh_hierarchy(LineReader& lines, std::string_view name);

/// "walk.bvh: line 3: expected ..., got ..."
[[noreturn]] void throw_bvh_error(std::string_view name, int line, const std::string& expected,
                                  const std::string& got);

/// Whether two words are the same but for capitals.
bool same_word(std::string_view a, std::string_view b);

}  // namespace percussionist::files
