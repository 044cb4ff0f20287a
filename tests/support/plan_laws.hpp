// What holds of every plan of strokes, whatever the score.
#pragma once

#include <doctest/doctest.h>

#include <vector>

#include "core/score/stroke_plan.hpp"

namespace percussionist::test {

/// Every note in exactly one of the plan's three lists.
inline void check_no_note_is_lost(const score::Score& score, const score::StrokePlan& plan) {
    std::vector<int> seen(score.notes.size(), 0);
    for (const auto& stroke : plan.strokes) {
        ++seen.at(stroke.note);
    }
    for (const auto* list : {&plan.left_out, &plan.doubles}) {
        for (const auto& left_out : *list) {
            ++seen.at(left_out.note);
        }
    }
    std::size_t once = 0;
    for (const int count : seen) {
        once += count == 1 ? 1 : 0;
    }
    CHECK(once == score.notes.size());
    CHECK(plan.strokes.size() + plan.left_out.size() + plan.doubles.size() == score.notes.size());
}

/// In order of time, each hand with its pause, and each stroke at its note's time and loudness.
inline void check_hands_can_play(const score::Score& score, const score::StrokePlan& plan,
                                 double min_interval) {
    double last[2] = {-1e9, -1e9};
    double before = -1e9;
    bool possible = true;
    for (const auto& stroke : plan.strokes) {
        possible = possible && stroke.time >= before &&
                   stroke.time - last[stroke.hand] >= min_interval &&
                   stroke.time == score.notes[stroke.note].time &&
                   stroke.velocity == score.notes[stroke.note].velocity && stroke.height > 0.0;
        before = last[stroke.hand] = stroke.time;
    }
    CHECK(possible);
}

}  // namespace percussionist::test
