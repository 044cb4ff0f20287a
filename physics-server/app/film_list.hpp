// What patches/film.pd is told, and when, as a file for Pd's [qlist]: the camera, the scene, poses,
// contacts, and "draw a picture".
#pragma once

#include <filesystem>
#include <fstream>

#include "osc/wire.hpp"
#include "sim/simulation.hpp"

namespace percussionist::app {

struct FilmOptions {
    int width = 960, height = 640;            ///< even [pixels]
    int rate = 30;                            ///< pictures a second; 60 is a multiple of it
    double azimuth = 40.0, elevation = 22.0;  ///< of the camera [degrees]
    double distance = 3.1;                    ///< from the drum [m]
};

class FilmList {
  public:
    /// Throws std::runtime_error if the file cannot be written.
    FilmList(const std::filesystem::path& path, const FilmOptions& options);

    void scene(const sim::Simulation& simulation, double drum_radius);
    void contact(const sim::ContactEvent& contact);
    /// To be called after each step: what is to be seen of it.
    void stepped(const sim::Simulation& simulation);
    /// Any message that the viewer understands, as it would come over OSC.
    void say(const osc::Packet& packet);
    /// Whether poses are due at a time [s] that grows from call to call; then they are to be said,
    /// and draw() called.
    [[nodiscard]] bool due(double time);
    void draw();
    /// Completes the file; how many pictures it asks for. Throws std::runtime_error.
    int finish();

  private:
    void pose(const sim::Simulation& simulation);

    std::filesystem::path path_;
    std::ofstream out_;
    FilmOptions options_;
    int poses_ = 0, pictures_ = 0;
};

}  // namespace percussionist::app
