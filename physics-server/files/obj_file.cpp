#include "files/obj_file.hpp"

#include <array>
#include <cstdio>

namespace percussionist::files {

namespace {

void append_line(std::string& to, const char* kind, const linear::Vector3& v) {
    std::array<char, 96> line{};
    std::snprintf(line.data(), line.size(), "%s %.4f %.4f %.4f\n", kind, v.x(), v.y(), v.z());
    to += line.data();
}

}  // namespace

std::string obj(const Mesh& mesh) {
    std::string text;
    for (const linear::Vector3& p : mesh.points) append_line(text, "v", p);
    for (const linear::Vector3& n : mesh.normals) append_line(text, "vn", n);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        text += 'f';
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string point = std::to_string(mesh.triangles[i + k] + 1);
            text += ' ' + point + "//" + point;
        }
        text += '\n';
    }
    return text;
}

}  // namespace percussionist::files
