#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/figure.hpp"
#include "app/kit_figure.hpp"
#include "files/obj_file.hpp"
#include "files/text_file.hpp"

namespace percussionist::app {

namespace {

/// The drum the shapes are made for; the viewer stretches them to the one it is told of [m].
constexpr double kRadius = 0.33, kHeight = 0.92;

void write_looks(const std::filesystem::path& folder, const files::SceneNode& node,
                 const Eigen::Affine3d& placed) {
    for (const files::PaintedMesh& look : node.looks) {
        files::write_text(folder / fmt::format("{}-{}.obj", node.name, look.paint.name),
                          files::obj(files::transformed(look.mesh, placed)));
    }
}

void write_figure(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const body::Skeleton skeleton = body::make_skeleton({});
    const std::vector<files::SceneNode> nodes = figure_nodes(skeleton);
    for (int i = 0; i < skeleton.size(); ++i) {
        // As /body tells of it: about the middle of the segment, in units of its size.
        const body::Segment& s = skeleton.segments[i];
        const linear::Vector3 middle = 0.5 * (s.joint_rest + s.end_rest);
        write_looks(folder, nodes[i],
                    Eigen::Affine3d(Eigen::Scaling(s.size.cwiseInverse().eval()) *
                                    Eigen::Translation3d(s.joint_rest - middle)));
    }
    write_looks(folder, drum_node({0.0, 0.0, kHeight}, kRadius), Eigen::Affine3d::Identity());
    // Kinds of objects by part, whatever it is made of: the viewer paints them.
    constexpr std::array kParts{"face", "body", "metal"};
    for (const files::SceneNode& shape : kit_shapes()) {
        for (std::size_t i = 0; i < shape.looks.size(); ++i) {
            files::write_text(folder / fmt::format("{}-{}.obj", shape.name, kParts[i]),
                              files::obj(shape.looks[i].mesh));
        }
    }
    files::SceneNode floor;
    floor.name = "floor";
    const files::Outline rings{{8.0, 0.0}, {6.0, 0.0}, {4.5, 0.0}, {3.5, 0.0},
                               {2.8, 0.0}, {2.2, 0.0}, {1.7, 0.0}, {1.3, 0.0},
                               {0.9, 0.0}, {0.5, 0.0}, {0.0, 0.0}};
    floor.looks.push_back({{"ground", {}}, files::turned(rings, 32)});
    write_looks(folder, floor, Eigen::Affine3d::Identity());
}

}  // namespace

void add_figure_command(CLI::App& program) {
    auto folder = std::make_shared<std::filesystem::path>();
    CLI::App& command = *program.add_subcommand(
        "figure", "the shapes of the percussionist and the drum, as OBJ files for the viewer");
    command.add_option("-o,--output", *folder, "folder for them (patches/viewer/figure)")
        ->required();
    command.callback([folder] { write_figure(*folder); });
}

}  // namespace percussionist::app
