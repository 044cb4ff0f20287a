// BVH (Biovision hierarchy) motion capture files: text in, plain values out.
//
// Reads what the usual programs write: channels in any order and number (0 to 6 a joint, positions
// anywhere among them), no End Site, zero offsets, any line ends, names with blanks, keywords in
// any case, several roots. Angles are applied in the order of the channels (intrinsic), as every
// such program means them. A file that is cut or miscounted is read as far as it goes, with a
// warning; a value that is no number is bridged from frame to frame, with a warning; what cannot be
// understood gives one BvhError with file, line and what was expected there. Memory grows with what
// is there, never with what is promised.
//
// Why not assimp: docs/motion.md.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "core/motion/capture.hpp"

namespace percussionist::files {

/// what(): "walk.bvh: line 14: expected 3 numbers after OFFSET, got 2"
struct BvhError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// `name` is what errors call the file. Throws BvhError.
motion::Capture parse_bvh(std::string_view text, std::string_view name);

/// Throws BvhError, also for a file that cannot be opened or is above 512 MB.
motion::Capture read_bvh_file(const std::filesystem::path& path);

}  // namespace percussionist::files
