#include "core/motion/pose_table.hpp"

#include <doctest/doctest.h>

using namespace percussionist::motion;

TEST_CASE("a row reads back as what was written") {
    const StationPose pose{1.25, 3, {{0.1, -0.25, 1e-4}, {0.5, -0.5, 0.5, 0.5}}};
    CHECK(to_row(pose) ==
          "1.250000,3,0.100000,-0.250000,0.000100,0.5000000,-0.5000000,0.5000000,0.5000000");
    const auto read = from_row(to_row(pose) + "\r");
    REQUIRE(read);
    CHECK(read->time == 1.25);
    CHECK(read->station == 3);
    CHECK(read->pose.position == pose.pose.position);
    CHECK(read->pose.orientation.coeffs() == pose.pose.orientation.coeffs());
}

TEST_CASE("what is no row is refused") {
    for (const char* bad : {"", "time [s],station", "1,1,0,0,0,1,0,0", "1,1,0,0,0,1,0,0,0,0",
                            "1,5,0,0,0,1,0,0,0", "1,1.5,0,0,0,1,0,0,0", "x,1,0,0,0,1,0,0,0",
                            "1,1,0,0,nan,1,0,0,0", "1,1,0,0,0,0,0,0,0", "1,1,,0,0,1,0,0,0"}) {
        CAPTURE(bad);
        CHECK_FALSE(from_row(bad));
    }
    CHECK(from_row(" 1 , 1, 0,0,0,1,0,0,0"));
}
