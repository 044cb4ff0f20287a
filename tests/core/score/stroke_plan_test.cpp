#include "core/score/stroke_plan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "support/plan_laws.hpp"

using namespace percussionist;
using namespace percussionist::score;

namespace {

Note note(double time, double velocity = 0.5, int instrument = 38) {
    return {time, instrument, velocity, 9, TempoMap().position_at(time)};
}

Score score_of(std::vector<Note> notes) {
    Score score;
    score.notes = std::move(notes);
    return score;
}

Score even(int count, double interval) {
    std::vector<Note> notes;
    for (int i = 0; i < count; ++i) {
        notes.push_back(note(i * interval));
    }
    return score_of(std::move(notes));
}

Score random_score(unsigned seed, int count, double mean_gap) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> gap(1.0 / mean_gap);
    std::uniform_int_distribution<int> instrument(35, 39);
    std::uniform_int_distribution<int> velocity(1, 127);
    std::vector<Note> notes;
    double time = 0.0;
    for (int i = 0; i < count; ++i) {
        time += i % 5 == 0 ? 0.0 : gap(random);
        notes.push_back(note(time, velocity(random) / 127.0, instrument(random)));
    }
    return score_of(std::move(notes));
}

/// The fewest notes two hands must leave out, by trying everything; no two notes in one group.
int fewest_left_out(const std::vector<Note>& notes, std::size_t i, double left, double right,
                    double min_interval) {
    if (i == notes.size()) {
        return 0;
    }
    int least = 1 + fewest_left_out(notes, i + 1, left, right, min_interval);
    const double t = notes[i].time;
    if (t - left >= min_interval) {
        least = std::min(least, fewest_left_out(notes, i + 1, t, right, min_interval));
    }
    if (t - right >= min_interval) {
        least = std::min(least, fewest_left_out(notes, i + 1, left, t, min_interval));
    }
    return least;
}

}  // namespace

TEST_CASE("no note is lost unsaid, and no hand moves faster than it can") {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const double mean_gap = 0.004 * (1 + seed % 30);
        const Score score = random_score(seed, 400, mean_gap);
        const StrokePlan plan = plan_strokes(score);
        test::check_no_note_is_lost(score, plan);
        test::check_hands_can_play(score, plan, PlanOptions{}.min_interval);
    }
}

TEST_CASE("as few notes are left out as can be") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> gap(0.013, 0.09);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Note> notes;
        double time = 0.0;
        for (int i = 0; i < 12; ++i) {
            notes.push_back(note(time += gap(random)));
        }
        const StrokePlan plan = plan_strokes(score_of(notes));
        CHECK(static_cast<int>(plan.left_out.size()) == fewest_left_out(notes, 0, -9, -9, 0.098));
    }
}

TEST_CASE("fast passages alternate") {
    for (const double interval : {0.06, 0.1, 0.15, 0.25}) {
        const StrokePlan plan = plan_strokes(even(40, interval));
        REQUIRE(plan.strokes.size() == 40);
        for (std::size_t i = 1; i < plan.strokes.size(); ++i) {
            CHECK(plan.strokes[i].hand != plan.strokes[i - 1].hand);
        }
    }
}

TEST_CASE("slow downbeats are the right hand's") {
    for (const Stroke& stroke : plan_strokes(even(20, 1.0)).strokes) {
        if (stroke.position.beat == 1.0) {
            CHECK(stroke.hand == kRight);
        }
    }
}

TEST_CASE("the two notes of a flam fall to different hands") {
    for (const double apart : {0.015, 0.030, 0.040}) {
        const StrokePlan plan = plan_strokes(score_of({note(1.0 - apart, 0.2), note(1.0, 0.9)}));
        REQUIRE(plan.strokes.size() == 2);
        CHECK(plan.strokes[0].hand != plan.strokes[1].hand);
    }
}

TEST_CASE("of three notes at one instant the two loudest are played, and the third is named") {
    const Score score = score_of({note(1.0, 0.9, 36), note(1.004, 0.3, 42), note(1.008, 0.6, 38)});
    const StrokePlan plan = plan_strokes(score);
    REQUIRE(plan.left_out.size() == 1);
    CHECK(plan.left_out[0].note == 1);
    CHECK(plan.left_out[0].why == Why::third_at_once);
    CHECK(describe(plan.left_out[0], score) ==
          "bar 1 beat 3.01 (1.004 s) closed hat: a third note at one instant, for two hands");
}

TEST_CASE("what is too fast is left out with the strokes that are in the way") {
    const Score score = score_of({note(1.0), note(1.03, 0.9), note(1.062, 0.1), note(1.2)});
    const StrokePlan plan = plan_strokes(score);
    REQUIRE(plan.left_out.size() == 1);
    CHECK(plan.left_out[0].note == 2);
    CHECK(plan.left_out[0].why == Why::too_fast);
    CHECK(plan.left_out[0].reason.find("62 ms before it") != std::string::npos);
    CHECK(plan.left_out[0].reason.find("32 ms before it") != std::string::npos);
}

TEST_CASE("among notes that cannot all be played the quietest goes") {
    const StrokePlan plan = plan_strokes(score_of({note(1.0, 0.2), note(1.03), note(1.06, 0.9)}));
    REQUIRE(plan.left_out.size() == 1);
    CHECK(plan.left_out[0].note == 0);
}

TEST_CASE("an event that comes twice is one stroke, as loud as the louder") {
    const StrokePlan plan = plan_strokes(score_of({note(1.0, 0.4), note(1.0005, 0.7)}));
    REQUIRE(plan.strokes.size() == 1);
    CHECK(plan.strokes[0].velocity == 0.7);
    REQUIRE(plan.doubles.size() == 1);
    CHECK(plan.doubles[0].note == 0);
    // Two instruments are two strokes.
    CHECK(plan_strokes(score_of({note(1.0, 0.4, 36), note(1.0, 0.7, 38)})).strokes.size() == 2);
}

TEST_CASE("instruments that were not asked for are left out, saying so") {
    const Score score = score_of({note(1.0, 0.5, 36), note(2.0, 0.5, 38), note(3.0, 0.5, 42)});
    const StrokePlan plan = plan_strokes(score, {0.098, {38}});
    CHECK(plan.strokes.size() == 1);
    REQUIRE(plan.left_out.size() == 2);
    CHECK(plan.left_out[0].why == Why::not_asked_for);
    test::check_no_note_is_lost(score, plan);
}

TEST_CASE("later notes make later strokes and nothing else") {
    Score score = random_score(7, 300, 0.08);
    const StrokePlan plan = plan_strokes(score);
    for (Note& n : score.notes) {
        n.time += 4.0;  // a power of two: exact
    }
    const StrokePlan later = plan_strokes(score);
    REQUIRE(later.strokes.size() == plan.strokes.size());
    for (std::size_t i = 0; i < plan.strokes.size(); ++i) {
        CHECK(later.strokes[i].note == plan.strokes[i].note);
        CHECK(later.strokes[i].hand == plan.strokes[i].hand);
    }
}

TEST_CASE("a louder note is a faster stroke, from 0.7 to 4.5 m/s, through what timpanists do") {
    for (int v = 1; v < 127; ++v) {
        CHECK(impact_speed((v + 1) / 127.0) > impact_speed(v / 127.0));
        CHECK(preparation_height(impact_speed((v + 1) / 127.0)) >
              preparation_height(impact_speed(v / 127.0)));
    }
    CHECK(impact_speed(1 / 127.0) == doctest::Approx(0.7));
    CHECK(impact_speed(67 / 127.0) == doctest::Approx(1.9).epsilon(0.03));
    CHECK(impact_speed(95 / 127.0) == doctest::Approx(2.8).epsilon(0.03));
    CHECK(impact_speed(1.0) == doctest::Approx(4.5));
    CHECK(preparation_height(1.9) == doctest::Approx(0.40));
    CHECK(preparation_height(4.4) == doctest::Approx(0.56).epsilon(0.01));
}

TEST_CASE("a hand in a hurry rises less") {
    const Stroke slow = plan_strokes(even(10, 0.5)).strokes.back();
    const Stroke fast = plan_strokes(even(10, 0.07)).strokes.back();
    CHECK(slow.height == preparation_height(slow.speed));
    CHECK(fast.height < 0.5 * slow.height);
    CHECK(fast.speed == slow.speed);
}

TEST_CASE("a note or a hand that cannot be is refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(plan_strokes(score_of({note(nan)})), std::invalid_argument);
    CHECK_THROWS_AS(plan_strokes(score_of({note(1.0, 0.0)})), std::invalid_argument);
    CHECK_THROWS_AS(plan_strokes(score_of({note(1.0, 1.1)})), std::invalid_argument);
    CHECK_THROWS_AS(plan_strokes({}, {0.0, {}}), std::invalid_argument);
    CHECK(plan_strokes({}).strokes.empty());
}
