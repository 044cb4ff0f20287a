#include "files/trajectory_file.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace percussionist;

namespace {

std::string error_of(const std::string& text) {
    try {
        files::parse_trajectories(text, "x.csv");
    } catch (const files::TrajectoryError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a mallet's recording: frames at 250 Hz, degrees, millimetres, whatever stands above") {
    for (const std::string header :
         {"", "Mallet 3\n250\n", "name\nFrame,RX,RY,RZ,TX,TY,TZ\n,deg,deg,deg,mm,mm,mm\n"}) {
        CAPTURE(header);
        const auto paths = files::parse_trajectories(
            header + "101,0,0,90,100,200,300\n102,0,0,90,101,200,300\n", "x.csv");
        REQUIRE(paths.size() == 1);
        REQUIRE(paths[0].samples.size() == 2);
        CHECK(paths[0].samples[1].time == doctest::Approx(0.004));
        CHECK(paths[0].samples[0].position.z() == doctest::Approx(0.3));
        const linear::Vector3 x = paths[0].samples[0].rotation * linear::Vector3::UnitX();
        CHECK((x - linear::Vector3::UnitY()).norm() < 1e-12);
    }
}

TEST_CASE("the tip's offset turns with the mallet") {
    files::TrajectoryOptions options;
    options.tip_offset = {0.3, 0.0, 0.0};
    const auto paths =
        files::parse_trajectories("1,0,0,90,0,0,0\n2,0,0,90,0,0,0\n", "x.csv", options);
    CHECK((paths[0].samples[0].position - linear::Vector3(0.0, 0.3, 0.0)).norm() < 1e-12);
}

TEST_CASE("named columns, units with the names, two hands") {
    const auto paths = files::parse_trajectories(
        "t_ms;left_x_mm;left_y_mm;left_z_mm;right_x_mm;right_y_mm;right_z_mm\n"
        "0;1;2;3;4;5;6\n10;1;2;3;4;5;6\n",
        "x.csv");
    REQUIRE(paths.size() == 2);
    CHECK(paths[1].samples[1].position.x() == doctest::Approx(0.004));
    CHECK(paths[0].samples[1].time == doctest::Approx(0.010));
}

TEST_CASE("gaps and times that do not ascend are left out, and told") {
    const auto paths = files::parse_trajectories(
        "t,x,y,z\n0,1,2,3\n0.01,,,\n0.02,1,2,3\n0.02,1,2,3\n0.03,nan,2,3\n", "x.csv");
    CHECK(paths[0].samples.size() == 2);
    CHECK(paths[0].warnings.size() == 2);
}

TEST_CASE("a wrong file: the line, and what was expected") {
    CHECK(error_of("") == "x.csv: line 0: expected at least two lines of 4 or more numbers, got 0");
    CHECK(error_of("t,x,y,z\n0,1,2,3\n0.1,1,b,3\n") == "x.csv: line 3: expected a number, got 'b'");
    CHECK(error_of("0,1,2,3,4\n0.5,1,2,3,4\n") ==
          "x.csv: line 1: expected columns named in a header, or 4, 7, 8 or 13 of them (time or "
          "frame first), got 5");
}
