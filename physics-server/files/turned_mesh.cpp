#include "files/turned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace percussionist::files {

namespace {

using linear::Vector3;

/// Below it a ring is a point [m].
constexpr double kPoint = 1e-9;

bool closed(const Outline& o) {
    return o.size() > 2 && std::abs(o.front().radius - o.back().radius) < kPoint &&
           std::abs(o.front().height - o.back().height) < kPoint;
}

/// Outwards, in the plane of the outline: x along the radius, y along the axis.
Eigen::Vector2d normal(const Outline& o, std::size_t i) {
    const std::size_t last = o.size() - 1;
    const bool ring = closed(o);
    if (!ring && (i == 0 || i == last) && o[i].radius < kPoint) {
        return {0.0, i == 0 ? -1.0 : 1.0};
    }
    const OutlinePoint& before = o[i > 0 ? i - 1 : (ring ? last - 1 : 0)];
    const OutlinePoint& after = o[i < last ? i + 1 : (ring ? 1 : last)];
    const Eigen::Vector2d n(after.height - before.height, before.radius - after.radius);
    return n.norm() > 0.0 ? n.normalized().eval() : Eigen::Vector2d(1.0, 0.0);
}

void check(const Outline& outline, int slices) {
    const bool sound =
        std::all_of(outline.begin(), outline.end(), [](const auto& p) { return p.radius >= 0.0; });
    if (outline.size() < 2 || !sound || slices < 3) {
        throw std::invalid_argument(
            "mesh: expected an outline of two points or more with radii from 0, and three slices");
    }
}

}  // namespace

Mesh turned(const Outline& outline, int slices) {
    check(outline, slices);
    Mesh mesh;
    const auto count = static_cast<std::uint32_t>(slices);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d n = normal(outline, i);
        for (int s = 0; s < slices; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / slices;
            const double c = std::cos(angle), d = std::sin(angle);
            mesh.points.emplace_back(outline[i].radius * c, outline[i].radius * d,
                                     outline[i].height);
            mesh.normals.emplace_back(n.x() * c, n.x() * d, n.y());
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring) {
        for (std::uint32_t s = 0; s < count; ++s) {
            const std::uint32_t a = ring * count + s, b = ring * count + (s + 1) % count;
            // Where a ring is a point one of the two triangles would be a line.
            if (outline[ring].radius > kPoint)
                mesh.triangles.insert(mesh.triangles.end(), {a, b, b + count});
            if (outline[ring + 1].radius > kPoint)
                mesh.triangles.insert(mesh.triangles.end(), {a, b + count, a + count});
        }
    }
    return mesh;
}

Outline ball(double radius, double height, int rings) {
    Outline outline;
    for (int i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        const double r = i == 0 || i == rings ? 0.0 : radius * std::sin(angle);
        outline.push_back({r, height - radius * std::cos(angle)});
    }
    return outline;
}

Outline smooth(const Outline& through, int steps) {
    Outline outline;
    const auto last = static_cast<int>(through.size()) - 1;
    for (int i = 0; i < last; ++i) {
        const OutlinePoint &a = through[std::max(i - 1, 0)], &b = through[i], &c = through[i + 1],
                           &d = through[std::min(i + 2, last)];
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            const auto between = [t](double p, double q, double r, double s) {
                return q + 0.5 * t *
                               ((r - p) +
                                t * ((2 * p - 5 * q + 4 * r - s) + t * (3 * (q - r) + s - p)));
            };
            outline.push_back({std::max(0.0, between(a.radius, b.radius, c.radius, d.radius)),
                               between(a.height, b.height, c.height, d.height)});
        }
    }
    outline.push_back(through.back());
    return outline;
}

Mesh transformed(const Mesh& mesh, const Eigen::Affine3d& by) {
    Mesh out = mesh;
    const linear::Matrix3 of_normals = by.linear().inverse().transpose();
    for (Vector3& p : out.points) p = by * p;
    for (Vector3& n : out.normals) n = (of_normals * n).normalized();
    return out;
}

void append(Mesh& to, const Mesh& more) {
    const auto first = static_cast<std::uint32_t>(to.points.size());
    to.points.insert(to.points.end(), more.points.begin(), more.points.end());
    to.normals.insert(to.normals.end(), more.normals.begin(), more.normals.end());
    for (const std::uint32_t i : more.triangles) to.triangles.push_back(first + i);
}

}  // namespace percussionist::files
