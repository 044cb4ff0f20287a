#include "app/gltf_motion.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/figure.hpp"
#include "app/performance.hpp"
#include "support/glb_reader.hpp"

using namespace percussionist;

namespace {

Eigen::Vector3f in_gltf(const linear::Vector3& v) {
    return linear::Vector3(v.y(), v.z(), v.x()).cast<float>();
}

std::vector<char> file_of(const app::GltfMotion& motion) {
    const auto path = std::filesystem::temp_directory_path() / "percussionist_gltf_motion.glb";
    motion.write(path);
    std::ifstream in(path, std::ios::binary);
    std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
    std::filesystem::remove(path);
    return bytes;
}

}  // namespace

TEST_CASE("in the file the sticks' tips and the drum are where the simulation has them") {
    app::Performance performance{sim::SimulationOptions()};
    performance.load(app::load_score({}).strokes);
    performance.play();
    const sim::Simulation& s = performance.simulation();
    app::GltfMotion motion(s.skeleton(), s.head_centre(), 0.33);
    std::vector<std::array<linear::Vector3, 2>> tips;
    for (int step = 0; step < 2000; ++step) {
        performance.step();
        if (step % 100 != 0) continue;
        motion.add(s.time(), s.placement());
        tips.push_back({s.placement().tip(s.skeleton(), body::Hand::left),
                        s.placement().tip(s.skeleton(), body::Hand::right)});
    }
    const auto bytes = file_of(motion);
    const test::GlbReader read(bytes);
    const Eigen::Vector3f tip(0.0F, 0.0F, static_cast<float>(s.skeleton().stick.reach()));
    float worst = 0.0F;
    for (std::size_t f = 0; f < tips.size(); ++f) {
        for (const body::Hand hand : {body::Hand::left, body::Hand::right}) {
            const int node = read.node(body::Skeleton::side(hand) + "stick");
            const Eigen::Vector3f there = in_gltf(tips[f][static_cast<int>(hand)]);
            worst = std::max(worst, (read.in_world(node, tip, f) - there).norm());
        }
    }
    CHECK(worst < 0.002F);  // joints of the physics engine give that much
    const Eigen::Vector3f head = read.in_world(read.node("drum"), Eigen::Vector3f::Zero(), 0);
    CHECK((head - in_gltf(s.head_centre())).norm() < 1e-6F);
}

TEST_CASE("the figure stands on the floor and is as tall as its stature") {
    const body::Skeleton skeleton = body::make_skeleton({});
    double lowest = 1.0, highest = 0.0;
    std::vector<linear::Vector3> place(skeleton.segments.size());
    const auto nodes = app::figure_nodes(skeleton);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        CHECK(!nodes[i].looks.empty());
        place[i] = nodes[i].place;
        if (nodes[i].parent >= 0) place[i] += place[nodes[i].parent];
        for (const auto& look : nodes[i].looks) {
            for (const auto& p : look.mesh.points) {
                lowest = std::min(lowest, p.z() + place[i].z());
                highest = std::max(highest, p.z() + place[i].z());
            }
        }
    }
    CHECK(lowest == doctest::Approx(0.0).epsilon(0.01));
    CHECK(highest == doctest::Approx(1.75).epsilon(0.02));
}
