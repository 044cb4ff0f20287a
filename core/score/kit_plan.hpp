// From notes to the strokes of a drummer's hands and feet, leaving out nothing unsaid.
//
// 1. A note's key names an event of the kit; some keys are nobody's.
// 2. Of notes on one object within a millisecond the loudest stays; the others are doubles.
// 3. Feet play what is theirs, at most every `foot` seconds (kit_feet.hpp).
// 4. Hits of the hands within 12 ms are one instant, with at most two hits: the two loudest; of
//    equally loud ones those whose events stand first in the kit.
// 5. Hands are found as one optimum over the piece (kit_sticking.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/score/kit.hpp"
#include "core/score/score.hpp"

namespace percussionist::score {

/// What told most for a hand, against the other.
enum class Reason {
    foot,         ///< it is a foot's
    only,         ///< the other hand could not
    pair,         ///< the pair's preference
    preference,   ///< the event's own hand
    alternation,  ///< the other hand would have to repeat fast
    way,          ///< the other hand had farther to go
    crossing,     ///< else the arms would cross
    lead,         ///< the right hand leads
    course,       ///< the other would be easier now, and harder for what follows or came before
};
inline constexpr std::array<std::string_view, 9> kReasonNames{
    "foot", "only", "pair", "preference", "alternation", "way", "crossing", "lead", "course"};

struct KitStroke {
    double time = 0.0;  ///< of the contact [s]
    Limb limb = Limb::right_hand;
    std::size_t event = 0;
    double velocity = 0.5;  ///< of the note, 0..1
    std::size_t note = 0;   ///< its index in the score
    bool bounces = false;   ///< the second of a bounced pair
    Reason reason = Reason::course;
};

struct KitLeftOut {
    std::size_t note = 0;
    std::string reason;  ///< in words, with the numbers
};

struct KitPlan {
    std::vector<KitStroke> strokes;    ///< in order of time
    std::vector<KitLeftOut> left_out;  ///< in order of time
    std::vector<KitLeftOut> doubles;   ///< in order of time
};

/// Every note of the score is in exactly one of the three lists. Throws std::invalid_argument for a
/// kit that check() refuses, more than a million notes, a note without time or velocity.
KitPlan plan_kit(const Score& score, const Kit& kit);

/// "bar 3 beat 2.50 (12.345 s) closed hat: ..." for a person to read.
std::string describe(const KitLeftOut& left_out, const Score& score);

/// What a strict onlooker counts against a plan.
struct KitAudit {
    std::size_t hits = 0;       ///< of hands
    std::size_t crossed = 0;    ///< hits within 0.25 s of the other hand's, arms across, not asked
    std::size_t too_fast = 0;   ///< a hand above 20 m/s, its top speed twice its mean
    std::size_t too_often = 0;  ///< a hand within 1/16 s of its last stroke
};
KitAudit audit(const KitPlan& plan, const Kit& kit);

}  // namespace percussionist::score
