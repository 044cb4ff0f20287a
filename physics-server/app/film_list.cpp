#include "app/film_list.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <stdexcept>

namespace percussionist::app {

namespace {

/// Trails are made of poses, which come as often as over the wire [Hz].
constexpr int kPoseRate = 60;
/// Pictures are drawn this much larger and made smaller by the script, which smooths their edges.
constexpr int kOversampling = 2;

std::string numbers(const linear::Vector3& v) {
    return fmt::format("{:.5f} {:.5f} {:.5f}", v.x(), v.y(), v.z());
}

}  // namespace

FilmList::FilmList(const std::filesystem::path& path, const FilmOptions& options)
    : path_(path), out_(path), options_(options) {
    // A window needs a while, and two pictures, before one can be taken from it.
    fmt::print(out_,
               "film-size {} {};\nviewer-distance {};\nviewer-elevation {};\nviewer-azimuth {};\n"
               "500;\nfilm-ready bang;\n500;\nfilm-ready bang;\n",
               kOversampling * options.width, kOversampling * options.height, options.distance,
               options.elevation, options.azimuth);
    if (!out_) throw std::runtime_error(path.string() + ": cannot be written");
}

void FilmList::scene(const sim::Simulation& simulation, double drum_radius) {
    for (const body::Segment& s : simulation.skeleton().segments) {
        const linear::Vector3 middle = 0.5 * (s.joint_rest + s.end_rest) - s.com_rest;
        fmt::print(out_, "viewer-message /body {} {} {};\n", s.name, numbers(middle),
                   numbers(s.size));
    }
    fmt::print(out_, "viewer-message /drum 0 {} {};\n", numbers(simulation.head_centre()),
               drum_radius);
}

void FilmList::contact(const sim::ContactEvent& c) {
    const double r = std::hypot(c.place.x(), c.place.y());
    const double theta = std::atan2(c.place.y(), c.place.x());
    fmt::print(out_,
               "viewer-message /contact 0 {} {} 0 {:.6f} {:.5f} {:.5f} {:.5f} {:.5f} {} {};\n",
               static_cast<int>(c.hand), c.drum, c.instant, c.place.x(), c.place.y(), r, theta,
               numbers(c.velocity), numbers(c.peak_force));
}

void FilmList::pose(const sim::Simulation& simulation) {
    const body::Placement& placement = simulation.placement();
    for (int i = 0; i < simulation.skeleton().size(); ++i) {
        const linear::Quaternion& q = placement.orientation[i];
        fmt::print(out_, "viewer-message /pose {} {} {:.6f} {:.6f} {:.6f} {:.6f};\n",
                   simulation.skeleton().segments[i].name, numbers(placement.com[i]), q.w(), q.x(),
                   q.y(), q.z());
    }
}

void FilmList::say(const osc::Packet& packet) {
    osc::decode(packet, [this](const std::string& path, std::span<const osc::Argument> arguments) {
        out_ << "viewer-message " << path;
        for (const osc::Argument& a : arguments) {
            const auto* number = std::get_if<double>(&a);
            out_ << ' ' << (number ? fmt::format("{:.6g}", *number) : std::get<std::string>(a));
        }
        out_ << ";\n";
    });
}

bool FilmList::due(double time) {
    if (time * kPoseRate < poses_) return false;
    if (poses_ > 0) fmt::print(out_, "{};\n", 1000.0 / kPoseRate);
    return true;
}

void FilmList::draw() {
    if (poses_++ % (kPoseRate / options_.rate) != 0) return;
    fmt::print(out_, "film-picture bang;\n");
    ++pictures_;
}

void FilmList::stepped(const sim::Simulation& simulation) {
    if (!due(simulation.time())) return;
    pose(simulation);
    draw();
}

int FilmList::finish() {
    fmt::print(out_, "100;\npd quit;\n");
    if (!out_.flush()) throw std::runtime_error(path_.string() + ": could not be written");
    return pictures_;
}

}  // namespace percussionist::app
