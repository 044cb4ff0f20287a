#include "app/kit_figure.hpp"

#include <cmath>
#include <numbers>

namespace percussionist::app {

namespace {

using files::Mesh;
using files::Outline;
using linear::Quaternion;
using linear::Vector3;

constexpr int kSlices = 32, kFewSlices = 8, kBox = 4;

const files::Paint kHead{"face", {0.95, 0.93, 0.87}, 0.7};
const files::Paint kShell{"body", {0.52, 0.09, 0.08}, 0.4};
const files::Paint kChrome{"metal", {0.75, 0.76, 0.80}, 0.3, 0.8};
const files::Paint kBrass{"brass", {0.80, 0.62, 0.25}, 0.35, 0.6};
const files::Paint kSteel{"steel", {0.36, 0.37, 0.40}, 0.4, 0.6};
const files::Paint kFelt{"felt", {0.85, 0.82, 0.75}, 0.9};
const files::Paint kLeather{"leather", {0.12, 0.12, 0.13}, 0.7};

Mesh turned(const Outline& outline, int slices = kSlices) {
    return files::turned(outline, slices);
}

/// Closed at both ends, with sharp edges.
Mesh cylinder(double radius, double from, double to, int slices = kSlices) {
    Mesh mesh = turned({{0.0, from}, {radius, from}}, slices);
    append(mesh, turned({{radius, from}, {radius, to}}, slices));
    append(mesh, turned({{radius, to}, {0.0, to}}, slices));
    return mesh;
}

Mesh ring(double inner, double outer, double from, double to) {
    return turned({{inner, from}, {outer, from}, {outer, to}, {inner, to}, {inner, from}});
}

/// A cymbal of radius 1: its bow falls to the edge, its bell rises; `up` -1: upside down.
Mesh cymbal(double up, double at) {
    const Outline above{{1.0, -0.075}, {0.8, -0.05}, {0.5, -0.02}, {0.27, 0.0},
                        {0.2, 0.03},   {0.12, 0.08}, {0.0, 0.095}};
    constexpr double kThick = 0.03;
    Outline outline;
    for (auto p = above.rbegin(); p != above.rend(); ++p) {
        outline.push_back({p->radius, p->height - kThick});
    }
    outline.insert(outline.end(), above.begin(), above.end());
    return files::transformed(
        turned(outline),
        Eigen::Affine3d(Eigen::Translation3d(0.0, 0.0, at) *
                        Eigen::AngleAxisd(up < 0.0 ? std::numbers::pi : 0.0, Vector3::UnitX())));
}

Mesh drum_metal() {
    constexpr int kLugs = 8;
    Mesh mesh = ring(0.975, 1.04, -0.10, 0.03);
    append(mesh, ring(0.975, 1.04, -1.03, -0.92));
    for (int i = 0; i < kLugs; ++i) {
        const Eigen::Affine3d to(
            Eigen::AngleAxisd(2.0 * std::numbers::pi * (i + 0.5) / kLugs, Vector3::UnitZ()) *
            Eigen::Translation3d(1.01, 0.0, 0.0));
        append(mesh, files::transformed(turned({{0.022, -0.95}, {0.022, -0.05}}, kBox), to));
    }
    return mesh;
}

files::SceneNode shape(const char* name, std::vector<files::PaintedMesh> looks) {
    files::SceneNode node;
    node.name = name;
    node.looks = std::move(looks);
    return node;
}

Mesh tripod() {
    constexpr double kHigh = 0.24, kOut = 0.26, kThick = 0.009;
    Mesh mesh;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 3.0 + 0.5;
        const Vector3 foot(kOut * std::cos(angle), kOut * std::sin(angle), 0.01);
        const Vector3 way = foot - Vector3(0.0, 0.0, kHigh);
        const Eigen::Affine3d to(Eigen::Translation3d(0.0, 0.0, kHigh) *
                                 Quaternion::FromTwoVectors(Vector3::UnitZ(), way));
        append(mesh, files::transformed(cylinder(kThick, 0.0, way.norm(), kFewSlices), to));
    }
    return mesh;
}

Mesh plate() {
    // A square turned on the lathe, its sides along x and y, 1 long and 9 cm wide.
    const Eigen::Affine3d to(Eigen::Translation3d(0.5, 0.0, 0.0) * Eigen::Scaling(1.0, 0.09, 1.0) *
                             Eigen::AngleAxisd(0.25 * std::numbers::pi, Vector3::UnitZ()));
    return files::transformed(cylinder(std::sqrt(0.5), -0.012, 0.0, kBox), to);
}

std::vector<files::PaintedMesh> looks_of(score::ObjectKind kind) {
    const Mesh felt = cylinder(0.06, 0.1, 0.16, kFewSlices);
    const Mesh nut = cylinder(0.03, 0.16, 0.22, kFewSlices);
    switch (kind) {
        case score::ObjectKind::drum:
            return {{kHead, turned({{0.98, 0.0}, {0.5, 0.0}, {0.0, 0.0}})},
                    {kShell, cylinder(0.97, -1.0, -0.005)},
                    {kChrome, drum_metal()}};
        case score::ObjectKind::cymbal:
            return {{kBrass, cymbal(1.0, 0.0)}, {kFelt, felt}, {kChrome, nut}};
        case score::ObjectKind::hi_hat:
            return {{kBrass, cymbal(1.0, 0.0)}, {kBrass, cymbal(-1.0, -0.16)}, {kChrome, nut}};
        case score::ObjectKind::bell:
            return {{kSteel, turned({{1.0, 0.0}, {0.0, 0.0}}, kBox)},
                    {kSteel, turned({{0.7, -1.0}, {1.0, 0.0}}, kBox)},
                    {kChrome, cylinder(0.3, -1.3, -1.0, kFewSlices)}};
    }
    return {};
}

/// Moved, turned and stretched.
void put(files::SceneNode& node, const files::SceneNode& shape, const Eigen::Affine3d& to) {
    for (const files::PaintedMesh& look : shape.looks) {
        node.looks.push_back({look.paint, files::transformed(look.mesh, to)});
    }
}

constexpr double kUpright = 0.5;     // of a face, or it stands on its own: its normal's z
constexpr double kSeatBelow = 0.08;  // the hip joints [m]

class KitScene {
  public:
    explicit KitScene(const score::Kit& kit) : kit_(kit), shapes_(kit_shapes()) {
        for (std::size_t o = 0; o < kit.objects.size(); ++o) add(o);
        for (const score::Pedal& pedal : kit.pedals) add(pedal);
        files::SceneNode seat = shape("seat", {});
        put(seat, named("kit-seat"), scaled({1.0, 1.0, kit.drummer.hips - kSeatBelow}));
        made_.nodes.push_back(std::move(seat));
    }
    KitNodes made() && { return std::move(made_); }

  private:
    static Eigen::Affine3d scaled(const Vector3& by) { return Eigen::Affine3d(Eigen::Scaling(by)); }

    const files::SceneNode& named(std::string_view name) const {
        for (const files::SceneNode& s : shapes_) {
            if (s.name == name) return s;
        }
        return shapes_.front();
    }

    void add(std::size_t index) {
        const score::KitObject& object = kit_.objects[index];
        const double deep = object.depth > 0.0 ? object.depth : object.radius;
        const Eigen::Affine3d to(object.orientation() *
                                 Eigen::Scaling(object.radius, object.radius, deep));
        files::SceneNode face = shape(object.name.c_str(), {});
        files::SceneNode rest = shape((object.name + "-stand").c_str(), {});
        face.place = rest.place = object.middle;
        const auto looks = looks_of(object.kind);
        face.looks.push_back({looks[0].paint, files::transformed(looks[0].mesh, to)});
        for (const std::size_t part : {1U, 2U}) {
            rest.looks.push_back({looks[part].paint, files::transformed(looks[part].mesh, to)});
        }
        if (object.normal().z() > kUpright) stand(rest, object.middle.z(), object.depth);
        made_.faces.push_back(made_.nodes.size());
        made_.nodes.push_back(std::move(face));
        made_.nodes.push_back(std::move(rest));
    }

    void stand(files::SceneNode& node, double height, double depth) const {
        const Eigen::Affine3d floor(Eigen::Translation3d(0.0, 0.0, -height));
        put(node, named("kit-rod"), floor * scaled({1.0, 1.0, height - depth}));
        put(node, named("kit-tripod"), floor);
    }

    void add(const score::Pedal& pedal) {
        const std::string name = kit_.objects[pedal.object].name;
        files::SceneNode node = shape((name + "-pedal").c_str(), {});
        node.place = pedal.heel;
        put(node, named("kit-pedal"), scaled({pedal.length, 1.0, 1.0}));
        made_.plates.push_back(made_.nodes.size());
        made_.beaters.push_back(made_.nodes.size());
        made_.nodes.push_back(std::move(node));
        const Beater beater = beater_of(pedal, kit_);
        if (beater.length <= 0.0) return;
        files::SceneNode swung = shape((name + "-beater").c_str(), {});
        swung.place = beater.pivot;
        put(swung, named("kit-rod"), scaled({1.0, 1.0, beater.length}));
        put(swung, named("kit-beater"),
            Eigen::Affine3d(Eigen::Translation3d(0.0, 0.0, beater.length)));
        made_.beaters.back() = made_.nodes.size();
        made_.nodes.push_back(std::move(swung));
    }

    const score::Kit& kit_;
    std::vector<files::SceneNode> shapes_;
    KitNodes made_;
};

}  // namespace

std::vector<files::SceneNode> kit_shapes() {
    std::vector<files::SceneNode> all;
    for (std::size_t kind = 0; kind < score::kObjectKindNames.size(); ++kind) {
        const std::string name = "kit-" + std::string(score::kObjectKindNames[kind]);
        all.push_back(shape(name.c_str(), looks_of(static_cast<score::ObjectKind>(kind))));
    }
    Mesh cushion =
        turned({{0.0, 0.90}, {0.15, 0.90}, {0.165, 0.93}, {0.165, 0.98}, {0.15, 1.0}, {0.0, 1.0}});
    all.push_back(shape("kit-rod", {{kSteel, cylinder(0.009, 0.0, 1.0, kFewSlices)}}));
    all.push_back(shape("kit-tripod", {{kSteel, tripod()}}));
    all.push_back(shape("kit-pedal", {{kSteel, plate()}}));
    all.push_back(
        shape("kit-beater", {{kFelt, files::turned(files::ball(0.028, -0.028, 6), kFewSlices)}}));
    all.push_back(shape(
        "kit-seat",
        {{kLeather, cushion}, {kSteel, cylinder(0.02, 0.0, 0.9, kFewSlices)}, {kSteel, tripod()}}));
    return all;
}

KitNodes kit_nodes(const score::Kit& kit) {
    return KitScene(kit).made();
}

Beater beater_of(const score::Pedal& pedal, const score::Kit& kit) {
    constexpr double kPivotAbove = 0.03;  // the plate's end [m]
    const score::KitObject& object = kit.objects[pedal.object];
    const Vector3 along(std::cos(pedal.direction), std::sin(pedal.direction), 0.0);
    Beater beater;
    beater.pivot = pedal.heel + pedal.length * along + kPivotAbove * Vector3::UnitZ();
    if (object.kind != score::ObjectKind::drum) return beater;
    const Vector3 way = object.middle - beater.pivot;
    beater.length = std::hypot(way.dot(along), way.z());
    beater.lean = std::atan2(way.dot(along), way.z());
    return beater;
}

}  // namespace percussionist::app
