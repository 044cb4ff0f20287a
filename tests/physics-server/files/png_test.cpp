#include "files/png.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace percussionist::files;

TEST_CASE("base 64 is that of its specification") {
    const auto of = [](const std::string& text) {
        return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
    };
    CHECK(of("") == "");
    CHECK(of("f") == "Zg==");
    CHECK(of("fo") == "Zm8=");
    CHECK(of("foo") == "Zm9v");
    CHECK(of("foobar") == "Zm9vYmFy");
}

TEST_CASE("a PNG ends with the chunk whose check the specification knows") {
    const std::vector<std::uint8_t> pixels = {0, 1, 1, 0, 0, 1};
    const std::vector<Colour> palette = {{0, 0, 0}, {255, 255, 255}};
    const auto bytes = png(3, 2, pixels, palette);
    const std::vector<std::uint8_t> end = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};
    CHECK(std::equal(end.rbegin(), end.rend(), bytes.rbegin()));
    CHECK_THROWS_AS(png(2, 2, pixels, palette), std::invalid_argument);
}
