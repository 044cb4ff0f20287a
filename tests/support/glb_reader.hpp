// A strict reader of .glb files as this project writes them: what breaks a rule of the
// specification throws and says which.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace percussionist::test {

class GlbReader {
  public:
    explicit GlbReader(const std::vector<char>& bytes) : bytes_(bytes) {
        demand(word(0) == 0x46546C67 && word(4) == 2 && word(8) == bytes.size(), "header");
        const std::size_t json = word(12);
        demand(word(16) == 0x4E4F534A && json % 4 == 0, "JSON chunk");
        gltf = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + json);
        const std::size_t binary = 20 + json;
        demand(word(binary + 4) == 0x004E4942 && word(binary) % 4 == 0, "binary chunk");
        start_ = binary + 8;
        demand(start_ + word(binary) == bytes.size(), "length of the binary chunk");
        demand(gltf.at("buffers").size() == 1 && gltf["buffers"][0]["byteLength"] == word(binary),
               "buffer");
        demand(gltf.at("asset").at("version") == "2.0", "version");
        check_nodes();
        check_meshes();
        if (gltf.contains("animations")) check_animation();
    }

    /// The values of an accessor, as many columns as its type has.
    template <class Value>
    std::vector<Value> values(int index, const std::string& type, int component) const {
        const auto& a = gltf.at("accessors").at(index);
        const auto& view = gltf.at("bufferViews").at(a.at("bufferView").get<int>());
        demand(a.at("type") == type && a.at("componentType") == component, "type of an accessor");
        const std::size_t count = a.at("count"), at = view.at("byteOffset");
        demand(at % 4 == 0 && view.at("byteLength") == count * sizeof(Value) &&
                   start_ + at + count * sizeof(Value) <= bytes_.size(),
               "place of an accessor");
        std::vector<Value> all(count);
        std::memcpy(static_cast<void*>(all.data()), bytes_.data() + start_ + at,
                    count * sizeof(Value));
        return all;
    }
    std::vector<Eigen::Vector3f> vectors(int index) const {
        return values<Eigen::Vector3f>(index, "VEC3", 5126);
    }

    /// Where a point of a node's frame lies in the world in frame `frame`.
    Eigen::Vector3f in_world(int node, Eigen::Vector3f point, std::size_t frame) const {
        for (; node >= 0; node = parent_[node]) {
            const auto& t = gltf["nodes"][node]["translation"];
            Eigen::Vector3f place(t[0].get<float>(), t[1].get<float>(), t[2].get<float>());
            Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
            if (gltf.contains("animations")) {
                const auto& animation = gltf["animations"][0];
                for (const auto& c : animation["channels"]) {
                    if (c["target"]["node"] != node) continue;
                    const int out = animation["samplers"][c["sampler"].get<int>()]["output"];
                    if (c["target"]["path"] == "rotation") {
                        turn.coeffs() = values<Eigen::Vector4f>(out, "VEC4", 5126).at(frame);
                    } else {
                        place = vectors(out).at(frame);
                    }
                }
            }
            point = turn * point + place;
        }
        return point;
    }

    int node(const std::string& name) const {
        for (std::size_t i = 0; i < gltf["nodes"].size(); ++i) {
            if (gltf["nodes"][i]["name"] == name) return static_cast<int>(i);
        }
        throw std::runtime_error("no node " + name);
    }

    nlohmann::json gltf;

  private:
    static void demand(bool holds, const char* what) {
        if (!holds) throw std::runtime_error(std::string("glTF broken: ") + what);
    }
    std::uint32_t word(std::size_t at) const {
        demand(at + 4 <= bytes_.size(), "a number beyond the end");
        std::uint32_t value = 0;
        std::memcpy(&value, bytes_.data() + at, 4);
        return value;
    }

    void check_nodes() {
        const auto& nodes = gltf.at("nodes");
        parent_.assign(nodes.size(), -1);
        std::size_t reached = gltf.at("scenes").at(0).at("nodes").size();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (const int child : nodes[i].value("children", std::vector<int>())) {
                demand(parent_.at(child) == -1 && child > static_cast<int>(i), "tree of nodes");
                parent_[child] = static_cast<int>(i);
                ++reached;
            }
            if (nodes[i].contains("mesh")) gltf.at("meshes").at(nodes[i]["mesh"].get<int>());
        }
        demand(reached == nodes.size(), "a node that is in no scene");
    }

    void check_meshes() const {
        for (const auto& mesh : gltf.at("meshes")) {
            for (const auto& p : mesh.at("primitives")) {
                const int position = p.at("attributes").at("POSITION");
                const auto points = vectors(position);
                const auto normals = vectors(p["attributes"].at("NORMAL"));
                demand(points.size() == normals.size(), "as many normals as points");
                for (const auto& n : normals) demand(std::abs(n.norm() - 1) < 1e-4F, "unit normal");
                const auto triangles = values<std::uint32_t>(p.at("indices"), "SCALAR", 5125);
                demand(!triangles.empty() && triangles.size() % 3 == 0, "triangles");
                for (const std::uint32_t i : triangles) demand(i < points.size(), "index");
                Eigen::Vector3f least = points[0], most = points[0];
                for (const auto& v : points) {
                    demand(v.allFinite(), "a number");
                    least = least.cwiseMin(v);
                    most = most.cwiseMax(v);
                }
                const auto& a = gltf["accessors"][position];
                for (int k = 0; k < 3; ++k) {
                    demand(a.at("min")[k].get<float>() == least[k] &&
                               a.at("max")[k].get<float>() == most[k],
                           "bounds");
                }
                gltf.at("materials").at(p.at("material").get<int>());
            }
        }
    }

    void check_animation() const {
        const auto& animation = gltf["animations"].at(0);
        for (const auto& c : animation.at("channels")) {
            const auto& sampler = animation.at("samplers").at(c.at("sampler").get<int>());
            const auto times = values<float>(sampler.at("input"), "SCALAR", 5126);
            for (std::size_t i = 1; i < times.size(); ++i) demand(times[i] > times[i - 1], "times");
            const int out = sampler.at("output");
            demand(gltf["accessors"].at(out).at("count") == times.size(), "a value for each time");
            if (c.at("target").at("path") != "rotation") continue;
            for (const auto& q : values<Eigen::Vector4f>(out, "VEC4", 5126)) {
                demand(std::abs(q.norm() - 1.0F) < 1e-4F, "unit rotation");
            }
        }
    }

    const std::vector<char>& bytes_;
    std::size_t start_ = 0;
    std::vector<int> parent_;
};

}  // namespace percussionist::test
