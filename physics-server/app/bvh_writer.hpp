// The motion of the body as a BVH file: degrees, metres, channels Z Y X.
//
// The hierarchy is the skeleton at rest; a stick's end is its End Site. Frames are streamed; the
// count in the header is filled in at the end.
#pragma once

#include <filesystem>
#include <fstream>

#include "body/posture.hpp"

namespace percussionist::app {

class BvhWriter {
  public:
    /// Throws std::runtime_error if the file cannot be written.
    BvhWriter(const std::filesystem::path& path, const body::Skeleton& skeleton, double frame_time);

    void add(const body::Placement& placement);
    /// Completes the file; throws std::runtime_error if it could not be written.
    void finish();

  private:
    void joint(int index, int depth);

    std::filesystem::path path_;
    std::ofstream out_;
    const body::Skeleton& skeleton_;
    std::vector<int> order_;  ///< segments as the hierarchy lists them
    std::streampos count_at_;
    int frames_ = 0;
};

}  // namespace percussionist::app
