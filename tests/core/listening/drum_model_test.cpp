#include "core/listening/drum_model.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "core/listening/practice/dice.hpp"
#include "core/listening/stroke_features.hpp"

using namespace percussionist::listening;

TEST_CASE("a model written and read judges as before") {
    DrumModel model = learnt_drums();
    DrumModel again = model_from_text(to_text(model));
    CHECK(again.second_threshold == model.second_threshold);
    practice::Dice dice(1);
    std::vector<float> features(kFeatures);
    for (float& f : features) f = static_cast<float>(dice.normal());
    const auto before = model.first.evaluate(features);
    const auto after = again.first.evaluate(features);
    for (std::size_t c = 0; c < kDrumClasses; ++c)
        CHECK(after[c] == doctest::Approx(before[c]).epsilon(0.02));
}

TEST_CASE("a damaged model is refused with the line that is wrong") {
    const std::string text = to_text(learnt_drums());
    CHECK_THROWS_WITH_AS(model_from_text(""), "drum model: line 1: expected percussionist drums 1",
                         std::invalid_argument);
    CHECK_THROWS_AS(model_from_text(text.substr(0, text.size() / 2)), std::invalid_argument);
    std::string wrong = text;
    wrong[text.find("layer") + 6] = 'x';
    CHECK_THROWS_WITH_AS(model_from_text(wrong), "drum model: line 3: expected a number of rows",
                         std::invalid_argument);
    std::string strange = text;
    strange[text.size() / 3] = '!';
    CHECK_THROWS_AS(model_from_text(strange), std::invalid_argument);
}
