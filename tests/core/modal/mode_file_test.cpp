#include "core/modal/mode_file.hpp"

#include <doctest/doctest.h>

#include <random>
#include <stdexcept>
#include <string>

using namespace percussionist::modal;

namespace {

GivenModes two_modes() {
    GivenModes given;
    given.name = "a drum";
    given.origin = "computed: by hand";
    given.radius = 0.1 + 0.2;
    given.places = {0.0, 1.0 / 3, 1.0};
    given.modes = {{100.1, 1.5, 0, {7.0, 5.5, 0.0}, 0.25}, {159.333, 0.7, 1, {0.0, 3.25, -1e-9}}};
    return given;
}

std::string fault(const std::string& text) {
    try {
        parse_modes(text);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a mode file is read back as it was written, to the last digit") {
    const auto given = two_modes();
    const auto read = parse_modes(write_modes(given));
    CHECK(read.name == given.name);
    CHECK(read.origin == given.origin);
    CHECK(read.radius == given.radius);
    CHECK(read.places == given.places);
    REQUIRE(read.modes.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(read.modes[k].frequency == given.modes[k].frequency);
        CHECK(read.modes[k].t60 == given.modes[k].t60);
        CHECK(read.modes[k].diameters == given.modes[k].diameters);
        CHECK(read.modes[k].weights == given.modes[k].weights);
        CHECK(read.modes[k].heard == given.modes[k].heard);
    }
    CHECK(sounding_modes(read) == 3);
}

TEST_CASE("a faulty mode file is refused, naming line and fault") {
    const std::string head = "percussionist modes 1\nplaces 0 0.5\n";
    CHECK(fault("").find("line 1: expected 'percussionist modes 1'") == 0);
    CHECK(fault("RIFF\x01\x02").find("line 1: ") == 0);
    CHECK(fault(head + "mode 100 1 0 x 1\n") == "line 3: expected a number, got 'x'");
    CHECK(fault(head + "mode 100 nan 0 1 1\n").find("line 3: ") == 0);
    CHECK(fault(head + "\n# none\nmode 100\n").find("line 5: expected mode FREQUENCY") == 0);
    CHECK(fault(head + "mode 100 1 0 1\n").find("mode 1: expected as many weights") == 0);
    CHECK(fault(head + "mode -5 1 0 1 1\n").find("mode 1: expected a frequency") == 0);
    CHECK(fault(head + "tune me\n").find("line 3: expected name") == 0);
    CHECK(fault(head).find("expected 1 to 8192 modes") != std::string::npos);
    CHECK(fault(head + "heard 1\n").find("line 3: expected heard") == 0);
}

TEST_CASE("a mode file spoilt anywhere is read or refused, no more") {
    const std::string whole = write_modes(two_modes());
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        std::string spoilt = whole;
        for (int n = 0; n < 3; ++n) {
            spoilt[random() % spoilt.size()] = static_cast<char>(random() % 256);
        }
        fault(spoilt.substr(0, random() % (spoilt.size() + 1)));
    }
    CHECK(fault(whole).empty());
}
