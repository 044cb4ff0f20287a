// Which hand plays what on a kit: one optimum over the whole piece.
//
// Dynamic programming over the groups of hits that are one instant (one or two hits). The state is
// what each hand played last and whether that bounced, forgotten after 0.8 s or 30 hits; the cost
// is that of HandEffort, and for a hit left out 1000 + 500 times its velocity: the fewest are left
// out, among as many the quieter ones. A state so far behind the best that two strokes more could
// not make up for it is dropped. Linear in the number of hits.
#pragma once

#include <span>
#include <vector>

#include "core/score/kit_effort.hpp"
#include "core/score/sticking.hpp"

namespace percussionist::score {

/// For each hit the hand that plays it. Groups in order of time, as sticking.hpp has them.
std::vector<Played> assign_hands(const Kit& kit, std::span<const HandHit> hits,
                                 std::span<const HitGroup> groups);

}  // namespace percussionist::score
