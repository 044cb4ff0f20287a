// The tables an animation is written as: strokes, key frames, and the kit's own motion.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "body/animation_check.hpp"
#include "core/score/kit_plan.hpp"

namespace percussionist::app {

/// "time_s,bar,beat,key,event,object,limb,velocity,bounced,reason,off_mm,early_ms", a line a
/// stroke.
std::string strokes_csv(const score::Kit& kit, const score::Score& score,
                        const std::vector<score::KitStroke>& strokes,
                        const std::vector<body::StrokeCheck>& checks);

/// "time_s,limb,kind,joint,z_deg,y_deg,x_deg", a line a joint of a key frame.
void write_keys(const std::filesystem::path& path, const body::KitAnimation& animation);

/// The motion of the kit's objects, a line a frame: "time_s", and of each object "NAME_flash",
/// "NAME_x_deg", "NAME_y_deg", "NAME_z_deg" (rotation vector about its middle, world),
/// "NAME_lift_m", and "NAME_pedal", "NAME_beater_deg" of those that have a pedal.
class ObjectsWriter {
  public:
    ObjectsWriter(const std::filesystem::path& path, const score::Kit& kit);
    void add(double time, const std::vector<body::ObjectState>& states);
    /// Throws std::runtime_error if the file could not be written.
    void finish();

  private:
    [[nodiscard]] bool has_pedal(std::size_t object) const;

    std::filesystem::path path_;
    std::ofstream out_;
    const score::Kit& kit_;
};

}  // namespace percussionist::app
