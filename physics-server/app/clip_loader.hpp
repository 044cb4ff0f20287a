// From files (BVH, CSV) to a body and the clip it is to follow, with what was done to them in
// words.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "body/clip.hpp"
#include "body/skeleton.hpp"

namespace percussionist::app {

struct ClipOptions {
    std::vector<std::filesystem::path> files;  ///< one; or two CSV files, left and right
    std::string map;      ///< of the skeleton: a ready one's name or a file; empty: the best
    double unit = 0.0;    ///< of a BVH file's lengths [m]; 0: find out
    double mass = 0.0;    ///< of the body [kg]; 0: from its stature
    double rate = 250.0;  ///< of a CSV file that counts frames [Hz]
    std::string hand;     ///< of a CSV file with one path: left or right; empty: its name's
    std::vector<double> tip_offset;  ///< of the tip in the mallet's frame, x y z [m]; empty: zero
    body::Anthropometry person;      ///< whose sticks they are, of CSV files
    bool wide_limits = true;         ///< the usual joint limits are widened to hold the clip
};

struct LoadedClip {
    body::Anthropometry person;
    body::Skeleton skeleton;  ///< make_skeleton(person), limits as asked for
    std::shared_ptr<const body::Clip> clip;
    std::vector<body::Posture> postures;  ///< as captured; empty if the clip is of sticks alone
    std::vector<std::string> report;      ///< what was matched, taken, mended
};

/// Throws std::runtime_error (files), std::invalid_argument (options).
LoadedClip load_clip(const ClipOptions& options);

/// The rotations of one joint throughout.
std::vector<body::Quaternion> rotations_of(const std::vector<body::Posture>& postures, int joint);

}  // namespace percussionist::app
