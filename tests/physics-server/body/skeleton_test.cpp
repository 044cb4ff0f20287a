#include "body/skeleton.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

using namespace percussionist::body;

TEST_CASE("skeleton: 19 joints of three axes, each with its name") {
    const Skeleton skeleton = make_skeleton({});
    std::set<std::string> joints;
    for (int i = 1; i < skeleton.size(); ++i) joints.insert(skeleton.segments[i].joint);
    CHECK(joints.size() == 19);
    CHECK(skeleton.size() == 20);
}

TEST_CASE("skeleton: the segments weigh what the person weighs") {
    Anthropometry person;
    person.mass = 68.0;
    const Skeleton skeleton = make_skeleton(person);
    double sum = 0.0;
    for (const Segment& s : skeleton.segments) sum += s.mass;
    // de Leva's table as it stands adds up to 100.0 %, to its last digit.
    CHECK(sum - 2 * person.stick.mass == doctest::Approx(person.mass).epsilon(0.001));
}

TEST_CASE("skeleton: left is right in a mirror") {
    const Skeleton skeleton = make_skeleton({});
    for (const Segment& s : skeleton.segments) {
        if (!s.name.starts_with("left_")) continue;
        const Segment& other = skeleton.segments[skeleton.index("right_" + s.name.substr(5))];
        CHECK(s.mass == other.mass);
        CHECK((s.com_rest - Vector3(1, -1, 1).cwiseProduct(other.com_rest)).norm() < 1e-12);
        CHECK(s.limits.lower_zyx.y() == other.limits.lower_zyx.y());
        CHECK(s.limits.lower_zyx.z() == -other.limits.upper_zyx.z());
    }
}

TEST_CASE("skeleton: moments of inertia are those of a body that can be") {
    for (const Segment& s : make_skeleton({}).segments) {
        CHECK(s.inertia.minCoeff() > 0.0);
        CHECK(2.0 * s.inertia.maxCoeff() <= s.inertia.sum() * (1.0 + 1e-9));
    }
}

TEST_CASE("skeleton: a person who cannot be is refused by name") {
    const auto refusal = [](const Anthropometry& person) -> std::string {
        try {
            make_skeleton(person);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    Anthropometry tall;
    tall.stature = 9.0;
    CHECK(refusal(tall).find("stature") != std::string::npos);
    Anthropometry unknown;
    unknown.mass = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(unknown).find("mass") != std::string::npos);
    Anthropometry no_stick;
    no_stick.stick.length = 0.0;
    CHECK(refusal(no_stick).find("stick length") != std::string::npos);
    CHECK_THROWS_AS((void)make_skeleton({}).index("tail"), std::out_of_range);
}
