// The motion of a drummer and of his kit as a glTF file: the figure, what stands about him, and
// each frame's posture, swings and pedals.
#pragma once

#include <filesystem>
#include <vector>

#include "app/kit_figure.hpp"
#include "body/kit_motion.hpp"
#include "files/gltf_file.hpp"

namespace percussionist::app {

class KitGltf {
  public:
    KitGltf(const body::Skeleton& skeleton, const score::Kit& kit);

    /// `time` [s] grows from frame to frame.
    void add(double time, const body::Placement& placement,
             const std::vector<body::ObjectState>& states);
    /// Throws std::runtime_error if the file cannot be written.
    void write(const std::filesystem::path& path) const { files::write_glb(path, scene_); }

  private:
    [[nodiscard]] linear::Quaternion turn_of(std::size_t node,
                                             const std::vector<body::ObjectState>& states) const;

    const body::Skeleton& skeleton_;
    const score::Kit& kit_;
    KitNodes kit_nodes_;  ///< numbered from the first of the kit
    files::MovingScene scene_;
};

}  // namespace percussionist::app
