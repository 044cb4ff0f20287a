#include "app/figure.hpp"

#include <string_view>

namespace percussionist::app {

namespace {

using files::Outline;
using linear::Quaternion;
using linear::Vector3;

const files::Paint kSkin{"skin", {0.86, 0.66, 0.52}, 0.7};
const files::Paint kShirt{"shirt", {0.20, 0.36, 0.58}, 0.9};
const files::Paint kTrousers{"trousers", {0.19, 0.20, 0.25}, 0.9};
const files::Paint kShoes{"shoes", {0.12, 0.11, 0.11}, 0.5};
const files::Paint kHair{"hair", {0.24, 0.17, 0.13}, 0.9};
const files::Paint kWood{"wood", {0.80, 0.62, 0.38}, 0.6};

// So few that a computer without a graphics card draws them 60 times a second.
constexpr int kSlices = 16, kSmallSlices = 8;
constexpr int kRings = 8, kSmallRings = 5, kSteps = 2;

/// A part of a segment: an outline along the segment, radii in metres, heights as shares of its
/// length from joint to end; across it may be flat.
struct Part {
    std::string_view segment;  ///< its name, without its side
    const files::Paint* paint;
    Outline outline;
    double depth = 1.0;  ///< of an upright one, front to back, against its width
};

const std::vector<Part>& parts() {
    // Radii of a man of 1.75 m, by eye.
    static const std::vector<Part> all{
        {"pelvis",
         &kTrousers,
         {{0, -0.40},
          {0.09, -0.36},
          {0.145, -0.10},
          {0.160, 0.30},
          {0.150, 0.75},
          {0.138, 1.0},
          {0.10, 1.12},
          {0, 1.16}},
         0.68},
        {"abdomen",
         &kShirt,
         {{0, -0.22},
          {0.10, -0.20},
          {0.146, -0.08},
          {0.142, 0.2},
          {0.140, 0.5},
          {0.150, 0.9},
          {0.12, 1.1},
          {0, 1.15}},
         0.66},
        {"chest",
         &kShirt,
         {{0, -0.25},
          {0.11, -0.20},
          {0.148, 0.0},
          {0.163, 0.4},
          {0.172, 0.75},
          {0.160, 1.08},
          {0.110, 1.40},
          {0.062, 1.58},
          {0, 1.62}},
         0.68},
        {"clavicle",
         &kShirt,
         {{0, -0.6}, {0.034, -0.4}, {0.044, 0.3}, {0.048, 0.9}, {0.036, 1.25}, {0, 1.35}}},
        {"upper_arm",
         &kShirt,
         {{0, -0.16},
          {0.034, -0.13},
          {0.053, 0.0},
          {0.055, 0.22},
          {0.051, 0.5},
          {0.045, 0.9},
          {0.036, 1.06},
          {0, 1.1}}},
        {"forearm",
         &kSkin,
         {{0, -0.13},
          {0.034, -0.08},
          {0.042, 0.05},
          {0.044, 0.25},
          {0.038, 0.6},
          {0.028, 0.95},
          {0.020, 1.05},
          {0, 1.08}}},
        {"thigh",
         &kTrousers,
         {{0, -0.12},
          {0.060, -0.08},
          {0.083, 0.04},
          {0.084, 0.25},
          {0.074, 0.6},
          {0.060, 0.95},
          {0.048, 1.05},
          {0, 1.1}}},
        {"shank",
         &kTrousers,
         {{0, -0.1},
          {0.045, -0.06},
          {0.057, 0.04},
          {0.060, 0.25},
          {0.052, 0.5},
          {0.043, 0.85},
          {0.044, 0.97},
          {0, 0.975}}},
    };
    return all;
}

files::Mesh along(const Outline& outline, const Vector3& axis, double depth = 1.0) {
    const Eigen::Affine3d to(Quaternion::FromTwoVectors(Vector3::UnitZ(), axis) *
                             Eigen::Scaling(depth, 1.0, 1.0));
    return files::transformed(files::turned(outline, kSlices), to);
}

files::Mesh egg(const Vector3& middle, const Vector3& half, double pitch = 0.0) {
    constexpr double kSmall = 0.025;
    const bool small = half.maxCoeff() < kSmall;
    const Eigen::Affine3d to(Eigen::Translation3d(middle) *
                             Eigen::AngleAxisd(pitch, Vector3::UnitY()) * Eigen::Scaling(half));
    return files::transformed(files::turned(files::ball(1.0, 0.0, small ? kSmallRings : kRings),
                                            small ? kSmallSlices : kSlices),
                              to);
}

void add_head(files::SceneNode& node, double length) {
    const Vector3 middle(0.015, 0.0, 0.62 * length);
    files::Mesh skin =
        along({{0.062, -0.05}, {0.055, 0.0}, {0.053, 0.3 * length}, {0.0, 0.6 * length}},
              Vector3::UnitZ());
    append(skin, egg(middle, {0.095, 0.076, 0.117}));
    append(skin, egg(middle + Vector3(0.028, 0.0, -0.062), {0.058, 0.054, 0.050}));  // the jaw
    append(skin,
           egg(middle + Vector3(0.094, 0.0, -0.016), {0.018, 0.012, 0.024}, -0.3));  // the nose
    for (const double side : {1.0, -1.0})
        append(skin, egg(middle + Vector3(-0.004, 0.076 * side, -0.005), {0.017, 0.009, 0.030}));
    node.looks.push_back({kSkin, skin});
    files::Mesh hair = egg(middle + Vector3(-0.020, 0.0, 0.026), {0.094, 0.083, 0.105}, -0.25);
    for (const double side : {1.0, -1.0}) {
        append(hair, egg(middle + Vector3(0.083, 0.031 * side, 0.008), {0.008, 0.009, 0.007}));
        append(hair, egg(middle + Vector3(0.084, 0.033 * side, 0.030), {0.008, 0.017, 0.004}));
    }
    node.looks.push_back({kHair, hair});
}

void add_hand(files::SceneNode& node, const Vector3& grip) {
    // A fist about the stick, and the thumb along it.
    files::Mesh mesh = egg(grip + Vector3(-0.020, 0.0, -0.004), {0.058, 0.041, 0.030});
    append(mesh, egg(grip + Vector3(0.012, 0.0, -0.016), {0.030, 0.038, 0.022}));
    const double inwards = node.name.starts_with("left") ? -1.0 : 1.0;
    append(mesh, egg(grip + Vector3(0.022, 0.026 * inwards, 0.010), {0.036, 0.012, 0.012}));
    node.looks.push_back({kSkin, mesh});
}

void add_foot(files::SceneNode& node, double height) {
    files::Mesh mesh = egg({0.06, 0.0, -height + 0.035}, {0.130, 0.046, 0.034});
    append(mesh, egg({-0.02, 0.0, -height + 0.045}, {0.052, 0.040, 0.042}));
    node.looks.push_back({kShoes, mesh});
}

void add_stick(files::SceneNode& node, const body::Stick& stick) {
    const double thick = 0.5 * stick.diameter, thin = 0.6 * thick, from = -stick.held_at;
    const double tip = stick.reach();
    files::Mesh mesh = along({{0.0, from},
                              {0.8 * thick, from + 0.002},
                              {thick, from + 0.008},
                              {thick, 0.55 * tip},
                              {thin, tip}},
                             Vector3::UnitX());
    append(mesh, along(files::ball(stick.tip_radius, tip, kRings), Vector3::UnitX()));
    node.looks.push_back({kWood, mesh});
}

/// The name of a segment without its side.
std::string_view kind_of(std::string_view name) {
    for (const std::string_view side : {"left_", "right_"}) {
        if (name.starts_with(side)) return name.substr(side.size());
    }
    return name;
}

void add_looks(files::SceneNode& node, const body::Skeleton& skeleton, const body::Segment& s) {
    const std::string_view kind = kind_of(s.name);
    const Vector3 whole = s.end_rest - s.joint_rest;
    for (const Part& part : parts()) {
        if (part.segment != kind) continue;
        Outline outline = files::smooth(part.outline, kSteps);
        for (files::OutlinePoint& p : outline) p.height *= whole.norm();
        node.looks.push_back({*part.paint, along(outline, whole.normalized(), part.depth)});
    }
    if (kind == "head") add_head(node, whole.norm());
    if (kind == "foot") add_foot(node, s.joint_rest.z());
    if (kind == "stick") add_stick(node, skeleton.stick);
    if (kind == "hand") {
        const int stick = skeleton.index(s.name.substr(0, s.name.size() - kind.size()) + "stick");
        add_hand(node, skeleton.segments[stick].joint_rest - s.joint_rest);
    }
}

}  // namespace

std::vector<files::SceneNode> figure_nodes(const body::Skeleton& skeleton) {
    std::vector<files::SceneNode> nodes;
    for (const body::Segment& s : skeleton.segments) {
        files::SceneNode node;
        node.name = s.name;
        node.parent = s.parent;
        node.place =
            s.parent < 0 ? s.joint_rest : s.joint_rest - skeleton.segments[s.parent].joint_rest;
        add_looks(node, skeleton, s);
        nodes.push_back(std::move(node));
    }
    return nodes;
}

}  // namespace percussionist::app
