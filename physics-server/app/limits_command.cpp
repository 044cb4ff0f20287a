#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include "app/clip_flags.hpp"
#include "app/commands.hpp"
#include "app/fit_axes.hpp"
#include "body/limits_from_motion.hpp"
#include "body/limits_text.hpp"
#include "files/text_file.hpp"

namespace percussionist::app {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct LimitsCommand {
    ClipOptions clip;
    std::string kind = "quaternion";
    std::filesystem::path output, picture;
};

/// Where the surface of the limits lies in a plane of two coordinates, as a closed line: an ellipse
/// of rotation vectors about the mean, or the outline of a box of angles.
files::Series outline(const body::JointLimits& limits, int across, int up) {
    files::Series line{"limits", files::Series::Kind::line, "#d62728", {}};
    if (limits.shape == body::LimitShape::box) {
        const auto& a = limits.lower_zyx;
        const auto& b = limits.upper_zyx;
        for (const auto& [x, y] : {std::pair{a[across], a[up]},
                                   {b[across], a[up]},
                                   {b[across], b[up]},
                                   {a[across], b[up]},
                                   {a[across], a[up]}}) {
            line.points.emplace_back(kDegrees * x, kDegrees * y);
        }
        return line;
    }
    constexpr int kParts = 72;
    for (int i = 0; i <= kParts; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kParts;
        line.points.emplace_back(kDegrees * limits.semi_axes[across] * std::cos(angle),
                                 kDegrees * limits.semi_axes[up] * std::sin(angle));
    }
    return line;
}

files::Chart chart(const std::string& segment, const body::JointLimits& limits,
                   const std::vector<body::Quaternion>& rotations, int across, int up) {
    const bool box = limits.shape == body::LimitShape::box;
    const auto name = [box](int axis) {
        return box ? fmt::format("angle {} [deg]", "zyx"[axis])
                   : fmt::format("axis {} [deg]", axis + 1);
    };
    files::Chart plot;
    plot.title = segment;
    plot.x.title = name(across);
    plot.y.title = name(up);
    files::Series seen{"seen", files::Series::Kind::points, "#1f77b4", {}};
    const std::size_t stride = 1 + rotations.size() / 800;
    for (std::size_t i = 0; i < rotations.size(); i += stride) {
        const body::Vector3 v =
            box ? body::euler_zyx(rotations[i])
                : body::Vector3(limits.axes.transpose() *
                                linear::quaternion_log(limits.mean.conjugate() * rotations[i]));
        seen.points.emplace_back(kDegrees * v[across], kDegrees * v[up]);
    }
    plot.series = {seen, outline(limits, across, up)};
    fit_axes(plot);
    return plot;
}

void run(const LimitsCommand& command) {
    LoadedClip clip = load_clip(command.clip);
    if (clip.postures.empty()) {
        throw std::invalid_argument("limits: expected captured joints (BVH); sticks have none");
    }
    body::LimitsBySegment all;
    std::vector<files::Chart> charts;
    fmt::print("{:<16} {:>28} {:>12}\n", "segment",
               command.kind == "euler" ? "ranges z y x [deg]" : "semi-axes [deg]", "admits");
    for (int i = 1; i < clip.skeleton.size(); ++i) {
        const std::string& segment = clip.skeleton.segments[i].name;
        const auto rotations = rotations_of(clip.postures, i);
        const body::JointLimits limits = command.kind == "euler"
                                             ? body::euler_limits(rotations)
                                             : body::ellipsoid_limits(rotations);
        all[segment] = limits;
        const body::Vector3 size = limits.shape == body::LimitShape::box
                                       ? body::Vector3(limits.upper_zyx - limits.lower_zyx)
                                       : limits.semi_axes;
        constexpr int kRotations = 200000;
        fmt::print("{:<16} {:>8.1f} {:>9.1f} {:>9.1f} {:>10.4f} %\n", segment, kDegrees * size[0],
                   kDegrees * size[1], kDegrees * size[2],
                   100.0 * body::admitted_share(limits, kRotations));
        charts.push_back(chart(segment, limits, rotations, 0, 1));
        charts.push_back(chart(segment, limits, rotations, 1, 2));
    }
    if (!command.output.empty()) files::write_text(command.output, body::limits_text(all));
    if (!command.picture.empty()) files::write_svg(command.picture, charts);
}

}  // namespace

void add_limits_command(CLI::App& program) {
    auto o = std::make_shared<LimitsCommand>();
    CLI::App& command = *program.add_subcommand(
        "limits",
        "the limits of each joint out of a captured motion: a file for track --limits, and "
        "a picture of what was seen and where the limits lie");
    add_clip_flags(command, o->clip);
    command
        .add_option("--kind", o->kind,
                    "euler (a box of angles) or quaternion (an ellipsoid about the mean)")
        ->check(CLI::IsMember({"euler", "quaternion"}))
        ->capture_default_str();
    command.add_option("-o,--output", o->output, "the file of limits");
    command.add_option("--picture", o->picture, "SVG");
    command.callback([o] { run(*o); });
}

}  // namespace percussionist::app
