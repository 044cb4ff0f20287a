#include <cmath>
#include <numbers>

#include "app/figure.hpp"

namespace percussionist::app {

namespace {

using files::Outline;
using linear::Quaternion;
using linear::Vector3;

const files::Paint kShell{"shell", {0.50, 0.10, 0.09}, 0.4};
const files::Paint kHead{"drumhead", {0.94, 0.92, 0.86}, 0.8};
const files::Paint kMetal{"metal", {0.75, 0.76, 0.80}, 0.3, 0.9};
const files::Paint kSteel{"steel", {0.36, 0.37, 0.40}, 0.4, 0.8};

constexpr int kSlices = 48, kSmallSlices = 8;
/// Of the drum, from hoop to hoop [m].
constexpr double kDrumDepth = 0.33;

files::Mesh round(const Outline& outline) {
    return files::turned(outline, kSlices);
}

/// Both hoops, and the lugs that hold them.
files::Mesh hoops(double radius) {
    constexpr double kHoop = 0.009;
    constexpr int kLugs = 8;
    Outline hoop;
    for (int i = 0; i <= kSmallSlices; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % kSmallSlices) / kSmallSlices;
        hoop.push_back({radius + kHoop * std::cos(angle), kHoop * std::sin(angle)});
    }
    files::Mesh mesh = round(hoop);
    for (files::OutlinePoint& p : hoop) p.height -= kDrumDepth;
    append(mesh, round(hoop));
    const Outline lug{{0.004, -kDrumDepth}, {0.004, -0.19}, {0.013, -0.185},
                      {0.013, -0.145},      {0.004, -0.14}, {0.004, 0.0}};
    for (int i = 0; i < kLugs; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kLugs;
        const Eigen::Affine3d to(Eigen::Translation3d((radius + 0.009) * std::cos(angle),
                                                      (radius + 0.009) * std::sin(angle), 0.0));
        append(mesh, files::transformed(files::turned(lug, kSmallSlices), to));
    }
    return mesh;
}

/// A post on three legs, seen from a head `height` above the floor.
files::Mesh stand(double height) {
    files::Mesh mesh =
        files::turned({{0.016, 0.10 - height}, {0.016, 0.02 - kDrumDepth}}, kSmallSlices);
    const Vector3 from(0.0, 0.0, 0.34 - height);
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 3.0;
        const Vector3 foot(0.30 * std::cos(angle), 0.30 * std::sin(angle), 0.012 - height);
        const Eigen::Affine3d to(
            Eigen::Translation3d(from) *
            Quaternion::FromTwoVectors(Vector3::UnitZ(), (foot - from).normalized()));
        const double length = (foot - from).norm();
        append(mesh, files::transformed(
                         files::turned({{0.010, 0.0}, {0.010, length}, {0.0, length + 0.01}},
                                       kSmallSlices),
                         to));
    }
    return mesh;
}

}  // namespace

files::SceneNode drum_node(const Vector3& head_centre, double radius) {
    files::SceneNode node;
    node.name = "drum";
    node.place = head_centre;
    node.looks.push_back({kHead, round({{radius, 0.0}, {0.0, 0.0}})});
    node.looks.push_back({kShell, round({{radius, -kDrumDepth}, {radius, -0.004}})});
    node.looks.push_back({kMetal, hoops(radius)});
    node.looks.push_back({kSteel, stand(head_centre.z())});
    return node;
}

}  // namespace percussionist::app
