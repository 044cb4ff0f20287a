#include "files/plot.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

using namespace percussionist::files;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

Chart chart() {
    Chart c{.title = "a < b", .x = {"Hz", 10, 1000, true}, .y = {"s", 0, 2, false}, .series = {}};
    c.series.push_back({.name = "dots",
                        .kind = Series::Kind::points,
                        .points = {{10, 0}, {100, 1}, {1000, 2}, {5, 1}, {100, std::nan("")}}});
    return c;
}

}  // namespace

TEST_CASE("a point stands where its axes say, and what lies outside is left out") {
    const std::string text = svg(std::array{chart()});
    CHECK(count(text, "<circle") == 3);
    // The middle of a logarithmic axis from 10 to 1000 is 100: between 70 and 940.
    CHECK(count(text, "cx=\"505\" cy=\"155\"") == 1);
    CHECK(count(text, "a &lt; b") == 1);
    CHECK(svg(std::array{chart()}) == text);
}

TEST_CASE("a file that cannot be written is named") {
    CHECK_THROWS_AS(write_svg("/no/such/folder/x.svg", std::array{chart()}), std::runtime_error);
}
