#include "files/gltf_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "files/text_file.hpp"

namespace percussionist::files {

namespace {

using Json = nlohmann::json;

// Numbers of the specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A,
                        kBinaryChunk = 0x004E4942;
static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

Eigen::Vector3f to_gltf(const Eigen::Vector3f& v) {
    return {v.y(), v.z(), v.x()};
}
Eigen::Quaternionf to_gltf(const Eigen::Quaternionf& q) {
    return {q.w(), q.y(), q.z(), q.x()};
}
Json as_json(const linear::Vector3& v) {
    const Eigen::Vector3f g = to_gltf(v.cast<float>());
    return {g.x(), g.y(), g.z()};
}

double light(double seen) {
    return seen <= 0.04045 ? seen / 12.92 : std::pow((seen + 0.055) / 1.055, 2.4);
}

class Writer {
  public:
    explicit Writer(const MovingScene& scene) : scene_(scene) {}

    std::vector<char> write() {
        gltf_["asset"] = {{"version", "2.0"}, {"generator", "percussionist"}};
        nodes();
        if (!scene_.times.empty()) animation();
        gltf_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
        return packed();
    }

  private:
    /// Appends values to the binary part; returns their accessor's index.
    template <class Value>
    int accessor(const std::vector<Value>& values, const char* type, int component, int target) {
        const std::size_t size = values.size() * sizeof(Value);
        Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
        if (target != 0) view["target"] = target;
        gltf_["bufferViews"].push_back(view);
        gltf_["accessors"].push_back({{"bufferView", gltf_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", values.size()},
                                      {"type", type}});
        const auto* bytes = reinterpret_cast<const char*>(values.data());
        binary_.insert(binary_.end(), bytes, bytes + size);
        return static_cast<int>(gltf_["accessors"].size()) - 1;
    }

    int vectors(const std::vector<linear::Vector3>& given) {
        std::vector<Eigen::Vector3f> values(given.size());
        std::transform(given.begin(), given.end(), values.begin(),
                       [](const linear::Vector3& v) { return to_gltf(v.cast<float>()); });
        return accessor(values, "VEC3", kFloat, kVertices);
    }

    int positions(const std::vector<linear::Vector3>& points) {
        Eigen::Vector3f least = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
        Eigen::Vector3f most = -least;
        for (const linear::Vector3& p : points) {
            least = least.cwiseMin(to_gltf(p.cast<float>()));
            most = most.cwiseMax(to_gltf(p.cast<float>()));
        }
        const int index = vectors(points);
        gltf_["accessors"][index]["min"] = {least.x(), least.y(), least.z()};
        gltf_["accessors"][index]["max"] = {most.x(), most.y(), most.z()};
        return index;
    }

    int material(const Paint& paint) {
        const auto [at, fresh] = materials_.emplace(paint.name, materials_.size());
        if (fresh) {
            const auto& c = paint.colour;
            gltf_["materials"].push_back(
                {{"name", paint.name},
                 {"pbrMetallicRoughness",
                  {{"baseColorFactor", {light(c[0]), light(c[1]), light(c[2]), 1.0}},
                   {"metallicFactor", paint.metal},
                   {"roughnessFactor", paint.roughness}}}});
        }
        return static_cast<int>(at->second);
    }

    int mesh(const SceneNode& node) {
        Json primitives = Json::array();
        for (const PaintedMesh& look : node.looks) {
            primitives.push_back(
                {{"attributes",
                  {{"POSITION", positions(look.mesh.points)},
                   {"NORMAL", vectors(look.mesh.normals)}}},
                 {"indices", accessor(look.mesh.triangles, "SCALAR", kUnsignedInt, kIndices)},
                 {"material", material(look.paint)}});
        }
        gltf_["meshes"].push_back({{"name", node.name}, {"primitives", primitives}});
        return static_cast<int>(gltf_["meshes"].size()) - 1;
    }

    void nodes() {
        Json nodes = Json::array(), roots = Json::array();
        for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
            const SceneNode& node = scene_.nodes[i];
            if (node.parent >= static_cast<int>(i)) {
                throw std::invalid_argument("glTF: " + node.name + " stands before its parent");
            }
            Json json = {{"name", node.name}, {"translation", as_json(node.place)}};
            if (!node.looks.empty()) json["mesh"] = mesh(node);
            nodes.push_back(json);
            (node.parent < 0 ? roots : nodes[node.parent]["children"]).push_back(i);
        }
        gltf_["nodes"] = nodes;
        gltf_["scenes"] = Json::array({{{"nodes", roots}}});
        gltf_["scene"] = 0;
    }

    void check_frames() const {
        const std::size_t frames = scene_.times.size();
        const bool grow = std::adjacent_find(scene_.times.begin(), scene_.times.end(),
                                             std::greater_equal<>()) == scene_.times.end();
        if (!grow || scene_.times.front() < 0.0 || scene_.turning > scene_.nodes.size() ||
            scene_.rotations.size() != frames * scene_.turning || scene_.moved.size() != frames ||
            std::any_of(scene_.shifted.begin(), scene_.shifted.end(), [&](const auto& shifted) {
                return shifted.first >= scene_.nodes.size() || shifted.second.size() != frames;
            })) {
            throw std::invalid_argument(
                "glTF: expected growing times, a rotation of each turning node and a place of the "
                "first for each of them");
        }
    }

    /// Adds a sampler of `output` over the frames, and a channel of it.
    void channel(Json& animation, int times, int output, std::size_t node, const char* path) {
        animation["samplers"].push_back(
            {{"input", times}, {"output", output}, {"interpolation", "LINEAR"}});
        animation["channels"].push_back({{"sampler", animation["samplers"].size() - 1},
                                         {"target", {{"node", node}, {"path", path}}}});
    }

    void animation() {
        check_frames();
        const std::vector<float> times(scene_.times.begin(), scene_.times.end());
        const int input = accessor(times, "SCALAR", kFloat, 0);
        gltf_["accessors"][input]["min"] = {times.front()};
        gltf_["accessors"][input]["max"] = {times.back()};
        Json animation = {{"name", "performance"}};
        for (std::size_t node = 0; node < scene_.turning; ++node) {
            const std::vector<Eigen::Vector4f> turns = rotations_of(node);
            channel(animation, input, accessor(turns, "VEC4", kFloat, 0), node, "rotation");
        }
        channel(animation, input, places(scene_.moved), 0, "translation");
        for (const auto& [node, shifted] : scene_.shifted) {
            channel(animation, input, places(shifted), node, "translation");
        }
        gltf_["animations"] = Json::array({animation});
    }

    int places(const std::vector<Eigen::Vector3f>& given) {
        std::vector<Eigen::Vector3f> values(given.size());
        std::transform(given.begin(), given.end(), values.begin(),
                       [](const Eigen::Vector3f& v) { return to_gltf(v); });
        return accessor(values, "VEC3", kFloat, 0);
    }

    /// x y z w, from frame to frame on the shorter way.
    [[nodiscard]] std::vector<Eigen::Vector4f> rotations_of(std::size_t node) const {
        std::vector<Eigen::Vector4f> turns;
        for (std::size_t frame = 0; frame < scene_.times.size(); ++frame) {
            const auto q = to_gltf(scene_.rotations[frame * scene_.turning + node]).normalized();
            Eigen::Vector4f turn = q.coeffs();
            if (!turns.empty() && turn.dot(turns.back()) < 0.0F) turn = -turn;
            turns.push_back(turn);
        }
        return turns;
    }

    [[nodiscard]] std::vector<char> packed() const {
        std::string json = gltf_.dump();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        constexpr std::size_t kHeader = 12, kChunkHeader = 8;
        const std::size_t size = kHeader + 2 * kChunkHeader + json.size() + binary_.size();
        if (size > std::numeric_limits<std::uint32_t>::max()) {
            throw std::length_error("glTF: a .glb holds at most 4 GB");
        }
        std::vector<char> bytes;
        bytes.reserve(size);
        const auto number = [&bytes](std::size_t value) {
            const auto word = static_cast<std::uint32_t>(value);
            const auto four = std::bit_cast<std::array<char, 4>>(word);
            bytes.insert(bytes.end(), four.begin(), four.end());
        };
        number(kMagic);
        number(kVersion);
        number(size);
        number(json.size());
        number(kJsonChunk);
        bytes.insert(bytes.end(), json.begin(), json.end());
        number(binary_.size());
        number(kBinaryChunk);
        bytes.insert(bytes.end(), binary_.begin(), binary_.end());
        return bytes;
    }

    const MovingScene& scene_;
    Json gltf_;
    std::vector<char> binary_;  ///< of values of four bytes, so that all of them are aligned
    std::map<std::string, std::size_t> materials_;
};

}  // namespace

std::vector<char> glb(const MovingScene& scene) {
    return Writer(scene).write();
}

void write_glb(const std::filesystem::path& path, const MovingScene& scene) {
    const std::vector<char> bytes = glb(scene);
    write_text(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace percussionist::files
