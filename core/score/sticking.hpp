// Which hand plays what: the search behind plan_strokes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::score {

struct Hit {
    double time = 0.0;      ///< [s]
    double velocity = 0.0;  ///< 0..1
    double beat = 1.0;      ///< in its bar, from 1
};

/// Hits that belong to one instant: one or two, in order of time.
struct HitGroup {
    std::size_t first = 0;  ///< index of a hit
    std::size_t count = 1;
};

enum class Played { left, right, not_at_all };

/// For each hit the hand that plays it. No hand strikes twice within `min_interval` [s]; the fewest
/// hits are left out; among such ways, the least awkward is taken. Linear in the number of hits.
std::vector<Played> assign_hands(std::span<const Hit> hits, std::span<const HitGroup> groups,
                                 double min_interval);

}  // namespace percussionist::score
