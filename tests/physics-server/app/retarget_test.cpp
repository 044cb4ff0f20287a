#include "body/retarget.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "body/captured_pose.hpp"
#include "files/bvh_file.hpp"
#include "support/real_data.hpp"

using namespace percussionist;

namespace {

double angle(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

TEST_CASE("the elbows bend as captured, whatever the make of the file") {
    for (const auto& path : test::real_files("bvh", ".bvh")) {
        CAPTURE(path.string());
        const motion::Capture capture = files::read_bvh_file(path);
        const body::SkeletonMatch match = body::match_best(capture);
        if (match.joints.size() < 15) continue;
        const body::RetargetedMotion motion = body::retarget(capture, match);
        CHECK(motion.person.stature > 1.2);
        CHECK(motion.person.stature < 2.1);
        const body::Skeleton skeleton = body::make_skeleton(motion.person);
        body::CapturedPose pose(capture, match);
        const std::size_t left_out = capture.frames() - motion.postures.size();
        const std::size_t frame = motion.postures.size() / 2;
        pose.take(frame + left_out);
        for (const std::string side : {"left_", "right_"}) {
            const auto upper = pose.line(side + "upper_arm", side + "forearm");
            const auto fore = pose.line(side + "forearm", side + "hand");
            REQUIRE(upper);
            REQUIRE(fore);
            const double captured = angle(upper->normalized().dot(fore->normalized()));
            const auto& q = motion.postures[frame].joints[skeleton.index(side + "forearm")];
            const double ours = angle(-(q * body::Vector3::UnitX()).z());
            CHECK(ours == doctest::Approx(captured).epsilon(0.02).scale(1.0));
        }
    }
}

TEST_CASE("names are matched without prefixes, capitals and signs; wrong maps say where") {
    motion::Capture capture;
    for (const char* name : {"mixamorig:Hips", "mixamorig:Left_Arm", "mixamorig:LEFTFOREARM"}) {
        capture.joints.push_back({name, -1, body::Vector3::Zero(), false});
    }
    const auto match = body::match_best(capture);
    CHECK(match.joints.at("left_upper_arm") == 1);
    CHECK(match.joints.at("left_forearm") == 2);
    CHECK_THROWS_WITH(body::parse_skeleton_map("# mine\nleft_wing: Wing\n", "my.map"),
                      doctest::Contains("my.map: line 2: expected a segment of the body"));
}
