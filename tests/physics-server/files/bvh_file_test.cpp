#include "files/bvh_file.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "support/real_data.hpp"

using namespace percussionist;

namespace {

std::string bvh(const std::string& channels, const std::string& motion) {
    return "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS " + channels +
           "\n  JOINT Left Arm {\n    OFFSET 1 2 3\n    CHANNELS 3 Xrotation Yrotation Zrotation\n"
           "  }\n}\nMOTION\n" +
           motion;
}

const std::string kSix = "6 Zrotation Xrotation Yrotation Xposition Yposition Zposition";

std::string error_of(const std::string& text) {
    try {
        files::parse_bvh(text, "x.bvh");
    } catch (const files::BvhError& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
    return text;
}

}  // namespace

TEST_CASE("rotations are applied in the order of the channels, wherever positions stand") {
    const auto capture =
        files::parse_bvh(bvh(kSix, "Frames: 1\nFrame Time: 0.01\n90 90 0 5 6 7 0 0 0\n"), "x.bvh");
    // First about z, then about the x that has turned with it: x goes to y, y to z.
    const linear::Vector3 x = capture.rotation(0, 0) * linear::Vector3::UnitX();
    const linear::Vector3 y = capture.rotation(0, 0) * linear::Vector3::UnitY();
    CHECK((x - linear::Vector3::UnitY()).norm() < 1e-12);
    CHECK((y - linear::Vector3::UnitZ()).norm() < 1e-12);
}

TEST_CASE("line ends, a byte order mark and capitals change nothing") {
    const std::string text = bvh(kSix, "Frames: 1\nFrame Time: .01\n1 2 3 4 5 6 7 8 9\n");
    const auto plain = files::parse_bvh(text, "x.bvh");
    for (const std::string& other :
         {replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), "\xEF\xBB\xBF" + text,
          replaced(replaced(text, "JOINT", "joint"), "Xrotation", "XROTATION")}) {
        const auto same = files::parse_bvh(other, "x.bvh");
        CHECK(same.joints[1].name == "Left Arm");
        CHECK(same.rotation(0, 1).coeffs() == plain.rotation(0, 1).coeffs());
    }
}

TEST_CASE("a file that is cut or miscounted is read as far as it goes, and says so") {
    const auto cut = files::parse_bvh(
        bvh(kSix, "Frames: 9\nFrame Time: 0.01\n1 2 3 4 5 6 7 8 9\n1 2 3"), "x.bvh");
    CHECK(cut.frames() == 1);
    CHECK(cut.warnings.size() == 2);
}

TEST_CASE("what is no number takes the value before it") {
    const auto capture = files::parse_bvh(
        bvh(kSix, "Frames: 2\nFrame Time: 0.01\n1 2 3 4 5 6 7 8 9\n1 2 3 4 5 6 nan 8 9\n"),
        "x.bvh");
    CHECK(capture.rotation(1, 1).coeffs() == capture.rotation(0, 1).coeffs());
    CHECK(capture.warnings.size() == 1);
}

TEST_CASE("a wrong file: the line, and what was expected") {
    CHECK(error_of("") == "x.bvh: line 0: expected HIERARCHY, got the end of the file");
    CHECK(error_of(bvh("3 Xrotation Yrotation Wrotation", "")) ==
          "x.bvh: line 5: expected Xposition, Yposition, Zposition, Xrotation, Yrotation or "
          "Zrotation, got 'Wrotation'");
    CHECK(error_of(bvh(kSix, "Frames: 1\nFrame Time: 0\n")) ==
          "x.bvh: line 13: expected a frame time of 0.001 to 10 s, got 'Frame Time: 0'");
    CHECK(error_of(bvh(kSix, "Frames: 2\nFrame Time: 0.1\n1 2 3 4 5 6 7 8\n1 2\n")) ==
          "x.bvh: line 14: expected 9 numbers, one a channel, got 8");
    CHECK(error_of(bvh(kSix, "Frames: 1\nFrame Time: 0.1\n1 2 3 4 x 6 7 8 9\n")) ==
          "x.bvh: line 14: expected a number, got 'x'");
    CHECK(error_of(bvh(kSix, "Frames: 1e12\nFrame Time: 0.1\n")) ==
          "x.bvh: line 13: expected a frame of numbers, got the end of the file");
}

TEST_CASE("real files of many makes are read whole") {
    for (const auto& path : test::real_files("bvh", ".bvh")) {
        CAPTURE(path.string());
        const auto capture = files::read_bvh_file(path);
        CHECK(capture.warnings.empty());
        CHECK(capture.frames() > 0);
    }
}
