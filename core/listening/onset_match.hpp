// How well what sounded agrees with what should have: two lists of instants, paired off.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::listening {

struct OnsetMatch {
    struct Pair {
        std::size_t expected = 0;  ///< index
        std::size_t found = 0;     ///< index
        double error = 0.0;        ///< found - expected - offset [s]
    };
    double offset = 0.0;  ///< median of found - expected: what is constant (latency) [s]
    std::vector<Pair> pairs;
    double median_error = 0.0;        ///< of |error| [s]
    double worst_error = 0.0;         ///< of |error| [s]
    std::vector<std::size_t> missed;  ///< expected, not found
    std::vector<std::size_t> extra;   ///< found, not expected
};

/// Pairs off two ascending lists of times [s] in order, each time with at most one of the other
/// list, no more than `tolerance` [s] away once the constant offset, at most `tolerance` too, is
/// taken out.
OnsetMatch match(std::span<const double> expected, std::span<const double> found, double tolerance);

}  // namespace percussionist::listening
