// Which hits a foot plays when there are more than it can: one optimum over the piece.
#pragma once

#include <span>
#include <vector>

namespace percussionist::score {

struct FootHit {
    double time = 0.0;      ///< [s]
    double velocity = 0.5;  ///< 0..1
};

/// True for those played: no two within `interval` [s], as many as can be, among as many the
/// louder ones. Hits in order of time; the time it takes grows linearly.
std::vector<bool> thin(std::span<const FootHit> hits, double interval);

}  // namespace percussionist::score
