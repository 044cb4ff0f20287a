#include <doctest/doctest.h>

#include <algorithm>

#include "core/score/stroke_plan.hpp"
#include "support/plan_laws.hpp"

using namespace percussionist;
using namespace percussionist::score;

TEST_CASE("two hands can play every note of the built-in piece") {
    const Score score = built_in_score();
    const StrokePlan plan = plan_strokes(score);
    CHECK(plan.strokes.size() == score.notes.size());
    test::check_hands_can_play(score, plan, PlanOptions{}.min_interval);
}

TEST_CASE("the built-in piece lasts half a minute at most and goes from pp to fff") {
    const Score score = built_in_score();
    CHECK(score.duration > 25.0);
    CHECK(score.duration < 30.0);
    const auto [softest, loudest] =
        std::minmax_element(score.notes.begin(), score.notes.end(),
                            [](const Note& a, const Note& b) { return a.velocity < b.velocity; });
    CHECK(softest->velocity < 0.1);
    CHECK(loudest->velocity == 1.0);
}

TEST_CASE("the built-in piece has flams, strokes of both hands, a roll and a silence") {
    const StrokePlan plan = plan_strokes(built_in_score());
    int flams = 0, together = 0, longest_roll = 0, roll = 0;
    double silence = 0.0;
    for (std::size_t i = 1; i < plan.strokes.size(); ++i) {
        const double gap = plan.strokes[i].time - plan.strokes[i - 1].time;
        flams += gap > 0.015 && gap < 0.040;
        together += gap == 0.0;
        roll = gap > 0.040 && gap < 0.1 ? roll + 1 : 0;
        longest_roll = std::max(longest_roll, roll);
        silence = std::max(silence, gap);
    }
    CHECK(flams >= 5);
    CHECK(together == 3);
    CHECK(longest_roll >= 35);
    CHECK(silence > 1.5);
}

TEST_CASE("instruments have names") {
    CHECK(instrument_name(35) == "low kick");
    CHECK(instrument_name(38) == "snare");
    CHECK(instrument_name(42) == "closed hat");
    CHECK(instrument_name(51) == "ride");
    CHECK(instrument_name(81) == "open triangle");
    CHECK(instrument_name(93) == "note 93");
}
