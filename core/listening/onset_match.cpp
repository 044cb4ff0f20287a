#include "core/listening/onset_match.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/listening/median.hpp"

namespace percussionist::listening {

namespace {

/// The two lists walked side by side: who has no partner within the tolerance is passed over; of
/// two that would take the same partner, the nearer one does.
std::vector<OnsetMatch::Pair> pair_off(std::span<const double> expected,
                                       std::span<const double> found, double offset,
                                       double tolerance) {
    std::vector<OnsetMatch::Pair> pairs;
    std::size_t e = 0;
    std::size_t f = 0;
    const auto error = [&](std::size_t i, std::size_t k) {
        return found[k] - expected[i] - offset;
    };
    while (e < expected.size() && f < found.size()) {
        if (std::abs(error(e, f)) > tolerance) {
            ++(error(e, f) > 0.0 ? e : f);
        } else if (f + 1 < found.size() && std::abs(error(e, f + 1)) < std::abs(error(e, f)) &&
                   (e + 1 == expected.size() ||
                    std::abs(error(e, f + 1)) < std::abs(error(e + 1, f + 1)))) {
            ++f;
        } else if (e + 1 < expected.size() && std::abs(error(e + 1, f)) < std::abs(error(e, f)) &&
                   (f + 1 == found.size() ||
                    std::abs(error(e + 1, f)) < std::abs(error(e + 1, f + 1)))) {
            ++e;
        } else {
            pairs.push_back({e, f, error(e, f)});
            ++e;
            ++f;
        }
    }
    return pairs;
}

/// The indices below `count` that are in no pair.
std::vector<std::size_t> alone(std::size_t count, const std::vector<OnsetMatch::Pair>& pairs,
                               std::size_t OnsetMatch::Pair::*side) {
    std::vector<std::size_t> rest;
    auto pair = pairs.begin();
    for (std::size_t i = 0; i < count; ++i) {
        if (pair != pairs.end() && (*pair).*side == i) {
            ++pair;
        } else {
            rest.push_back(i);
        }
    }
    return rest;
}

}  // namespace

OnsetMatch match(std::span<const double> expected, std::span<const double> found,
                 double tolerance) {
    if (!(tolerance >= 0.0)) {
        throw std::invalid_argument("match: the tolerance must be 0 or more");
    }
    std::vector<double> offsets;
    for (const auto& pair : pair_off(expected, found, 0.0, tolerance)) {
        offsets.push_back(pair.error);
    }
    OnsetMatch match;
    match.offset = median(offsets);
    match.pairs = pair_off(expected, found, match.offset, tolerance);
    std::vector<double> errors;
    for (const auto& pair : match.pairs) {
        errors.push_back(std::abs(pair.error));
        match.worst_error = std::max(match.worst_error, errors.back());
    }
    match.median_error = median(errors);
    match.missed = alone(expected.size(), match.pairs, &OnsetMatch::Pair::expected);
    match.extra = alone(found.size(), match.pairs, &OnsetMatch::Pair::found);
    return match;
}

}  // namespace percussionist::listening
