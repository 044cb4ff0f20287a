#include "files/gltf_file.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

#include "support/glb_reader.hpp"

using namespace percussionist;
using files::MovingScene;
using files::SceneNode;

namespace {

MovingScene scene_of_two() {
    SceneNode arm;
    arm.name = "arm \"1\"";
    arm.place = {1.0, 2.0, 3.0};
    arm.looks.push_back({{"red", {1.0, 0.0, 0.0}}, files::turned(files::ball(0.1, 0.0), 8)});
    SceneNode hand = arm;
    hand.name = "hand";
    hand.parent = 0;
    hand.place = {0.5, 0.0, 0.0};
    SceneNode stand;
    stand.name = "stand";
    MovingScene scene;
    scene.nodes = {arm, hand, stand};
    scene.turning = 2;
    const Eigen::Quaternionf quarter(
        Eigen::AngleAxisf(static_cast<float>(M_PI / 2), Eigen::Vector3f::UnitZ()));
    for (int frame = 0; frame < 3; ++frame) {
        scene.times.push_back(0.1 * frame);
        scene.moved.emplace_back(1.0F, 2.0F, 3.0F);
        scene.rotations.push_back(frame == 0 ? Eigen::Quaternionf::Identity() : quarter);
        scene.rotations.push_back(Eigen::Quaternionf::Identity());
    }
    return scene;
}

}  // namespace

TEST_CASE("a scene is a .glb by the rules of the specification, the same each time") {
    const auto bytes = files::glb(scene_of_two());
    const test::GlbReader read(bytes);
    CHECK(read.gltf["nodes"].size() == 3);
    CHECK(read.gltf["nodes"][0]["name"] == "arm \"1\"");
    CHECK(read.gltf["materials"].size() == 1);
    CHECK(bytes == files::glb(scene_of_two()));
}

TEST_CASE("front becomes z, left x, up y; metres stay metres") {
    const auto bytes = files::glb(scene_of_two());
    const test::GlbReader read(bytes);
    const Eigen::Vector3f none = Eigen::Vector3f::Zero();
    CHECK((read.in_world(0, none, 0) - Eigen::Vector3f(2, 3, 1)).norm() < 1e-6F);
    CHECK((read.in_world(1, none, 0) - Eigen::Vector3f(2, 3, 1.5)).norm() < 1e-6F);
    // A quarter turn about up takes what was in front to the left.
    CHECK((read.in_world(1, none, 1) - Eigen::Vector3f(2.5, 3, 1)).norm() < 1e-6F);
}

TEST_CASE("rotations never go the longer way round from frame to frame") {
    MovingScene scene = scene_of_two();
    scene.rotations[4].coeffs() *= -1.0F;
    const auto bytes = files::glb(scene);
    const test::GlbReader read(bytes);
    const auto& animation = read.gltf["animations"][0];
    const auto turns =
        read.values<Eigen::Vector4f>(animation["samplers"][0]["output"], "VEC4", 5126);
    CHECK(turns[1].dot(turns[2]) > 0.0F);
}

TEST_CASE("what does not fit together is refused") {
    MovingScene scene = scene_of_two();
    scene.nodes[0].parent = 1;
    CHECK_THROWS_AS(files::glb(scene), std::invalid_argument);
    scene = scene_of_two();
    scene.times[1] = scene.times[0];
    CHECK_THROWS_AS(files::glb(scene), std::invalid_argument);
    scene = scene_of_two();
    scene.rotations.pop_back();
    CHECK_THROWS_AS(files::glb(scene), std::invalid_argument);
    CHECK_THROWS_AS(files::write_glb("/nowhere/at/all.glb", scene_of_two()), std::runtime_error);
}
