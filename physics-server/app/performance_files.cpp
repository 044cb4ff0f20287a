#include "app/performance_files.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "app/drum_sound.hpp"

namespace percussionist::app {

namespace {

std::filesystem::path made(std::filesystem::path folder) {
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace

void add_file_flags(CLI::App& command, FileOptions& options) {
    command.add_option("--frames", options.frames, "of the motion [Hz]")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    command.add_option("--sample-rate", options.sample_rate, "of the sound [Hz]")
        ->check(CLI::Range(8000, 192000))
        ->capture_default_str();
}

PerformanceFiles::PerformanceFiles(std::filesystem::path folder, const FileOptions& options,
                                   const Performance& performance)
    : folder_(made(std::move(folder))),
      options_(options),
      performance_(performance),
      bvh_(folder_ / "motion.bvh", performance.simulation().skeleton(), 1.0 / options.frames),
      gltf_(performance.simulation().skeleton(), performance.simulation().head_centre(),
            performance.simulation().options().head.membrane.radius) {}

void PerformanceFiles::stepped() {
    const sim::Simulation& simulation = performance_.simulation();
    if (simulation.time() * options_.frames < frames_) return;
    bvh_.add(simulation.placement());
    gltf_.add(simulation.time(), simulation.placement());
    ++frames_;
}

double PerformanceFiles::finish() {
    bvh_.finish();
    gltf_.write(folder_ / "motion.glb");
    performance_.log().write_csv(folder_ / "contacts.csv");
    const sim::Simulation& simulation = performance_.simulation();
    const files::Audio sound = drum_sound(performance_.log(), simulation.time(),
                                          options_.sample_rate, simulation.options().head);
    files::write_wav(folder_ / "performance.wav", sound);
    return peak(sound);
}

}  // namespace percussionist::app
