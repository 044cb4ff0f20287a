#include "core/listening/own_drums.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace percussionist::listening;

namespace {

StrokePrint print(float low, float high) {
    StrokePrint made{};
    for (std::size_t i = 0; i < kPrint; ++i) made[i] = i % 16 < 8 ? low : high;
    return made;
}

OwnDrums two_drums() {
    OwnDrums drums;
    const auto dark = *drums.named("dark"), bright = *drums.named("bright");
    for (const float v : {-0.1F, 0.0F, 0.1F}) {
        drums[dark].learn(print(-1.0F + v, -8.0F + v), -3.0F);
        drums[bright].learn(print(-8.0F + v, -1.0F + v), -3.0F);
    }
    return drums;
}

}  // namespace

TEST_CASE("a stroke is of the drum whose print is nearest, or of none") {
    const OwnDrums drums = two_drums();
    CHECK(drums.nearest(print(-1.2F, -7.5F))->drum == 0);
    CHECK(drums.nearest(print(-7.5F, -1.2F))->drum == 1);
    CHECK(drums.nearest(print(-7.5F, -1.2F))->confidence > 0.7);
    CHECK(!drums.nearest(print(-4.5F, -4.5F)));
}

TEST_CASE("drums written and read are the same") {
    const OwnDrums drums = two_drums();
    const OwnDrums again = own_drums_from_text(to_text(drums));
    REQUIRE(again.size() == 2);
    CHECK(std::string(again[1].name.data()) == "bright");
    CHECK(again[1].strokes == 3);
    CHECK(again[1].mean[3] == doctest::Approx(drums[1].mean[3]));
}

TEST_CASE("a text that is no drums is refused with its line") {
    CHECK_THROWS_WITH(own_drums_from_text("nonsense"),
                      "own drums: line 1: expected percussionist-own-drums-1");
    CHECK_THROWS_WITH(own_drums_from_text("percussionist-own-drums-1\nsnare 3 x\n"),
                      "own drums: line 2: expected strokes, loudness and 96 numbers");
    CHECK_THROWS_AS(own_drums_from_text(to_text(two_drums()) + "dark 1 2\n"),
                    std::invalid_argument);
}

TEST_CASE("names that could not be saved are refused, and so is a seventeenth drum") {
    OwnDrums drums;
    CHECK(!drums.named(""));
    CHECK(!drums.named("two words"));
    CHECK(!drums.named(std::string(32, 'x')));
    for (int i = 0; i < 16; ++i) CHECK(drums.named("drum" + std::to_string(i)));
    CHECK(!drums.named("one-more"));
    CHECK(*drums.named("drum3") == 3);
}
