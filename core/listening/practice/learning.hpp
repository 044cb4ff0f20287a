// Learning to tell drums apart, from practice pieces: how the model that listening uses is made.
//
// The second network must not learn from judgements on what the first had learnt by heart: two
// more first networks, each learnt on one half of the pieces, judge the other half for it. Where a
// class counts as struck is decided on pieces that no network has learnt from.
//
// Deterministic for the same lessons and seed.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/listening/drum_model.hpp"
#include "core/listening/evidence.hpp"
#include "core/listening/practice/piece_of_music.hpp"

namespace percussionist::listening::practice {

/// What was heard of a practice piece, and what had been struck.
struct Lesson {
    Evidence evidence;
    std::vector<HeardStroke> strokes;
};

Lesson lesson(const PieceOfMusic& piece);

struct LearningOptions {
    int epochs = 15;
    std::uint64_t seed = 7;
};

/// progress(share done, what is being done). Throws std::invalid_argument for less than 20 lessons.
DrumModel learn(const std::vector<Lesson>& lessons, const LearningOptions& options,
                const std::function<void(double, const char*)>& progress = {});

}  // namespace percussionist::listening::practice
