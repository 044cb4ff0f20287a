// The motion of the percussionist as a glTF file: the figure, the drum, and each frame's posture.
#pragma once

#include <filesystem>

#include "body/posture.hpp"
#include "files/gltf_file.hpp"

namespace percussionist::app {

class GltfMotion {
  public:
    GltfMotion(const body::Skeleton& skeleton, const linear::Vector3& head_centre,
               double drum_radius);

    /// `time` [s] grows from frame to frame.
    void add(double time, const body::Placement& placement);
    /// Throws std::runtime_error if the file cannot be written.
    void write(const std::filesystem::path& path) const { files::write_glb(path, scene_); }

  private:
    const body::Skeleton& skeleton_;
    files::MovingScene scene_;
};

}  // namespace percussionist::app
