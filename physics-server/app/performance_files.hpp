// The files of a performance: contacts.csv, motion.bvh, motion.glb, performance.wav.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>

#include "app/bvh_writer.hpp"
#include "app/gltf_motion.hpp"
#include "app/performance.hpp"

namespace percussionist::app {

struct FileOptions {
    double frames = 120.0;  ///< a second, of the motion [Hz]
    int sample_rate = 48000;
};

/// --frames and --sample-rate.
void add_file_flags(CLI::App& command, FileOptions& options);

class PerformanceFiles {
  public:
    /// Throws std::runtime_error if the folder or a file in it cannot be written.
    PerformanceFiles(std::filesystem::path folder, const FileOptions& options,
                     const Performance& performance);

    /// To be called after each step.
    void stepped();
    /// Completes them, the sound with the head and the sticks as they are now; its peak level.
    /// Throws std::runtime_error.
    double finish();

  private:
    std::filesystem::path folder_;
    FileOptions options_;
    const Performance& performance_;
    BvhWriter bvh_;
    GltfMotion gltf_;
    int frames_ = 0;
};

}  // namespace percussionist::app
