#include "core/modal/given_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/modal/membrane.hpp"

namespace percussionist::modal {

namespace {

[[noreturn]] void refuse(const std::string& what, double value) {
    throw std::invalid_argument(what + ", got " + std::to_string(value));
}

void check_places(const std::vector<double>& places) {
    if (places.empty() || places.size() > 64) {
        refuse("modes: expected 1 to 64 places", static_cast<double>(places.size()));
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool rises = i == 0 || places[i] > places[i - 1];
        if (!(places[i] >= 0.0 && places[i] <= 1.0 && rises)) {
            refuse("modes: expected places rising from 0 to 1", places[i]);
        }
    }
}

void check_mode(const GivenMode& mode, std::size_t number, std::size_t places) {
    const std::string name = "mode " + std::to_string(number + 1) + ": ";
    if (!(std::isfinite(mode.frequency) && mode.frequency > 0.0)) {
        refuse(name + "expected a frequency above 0 [Hz]", mode.frequency);
    }
    if (!(mode.t60 > 0.0)) {
        refuse(name + "expected a t60 above 0 [s]", mode.t60);
    }
    if (mode.diameters < 0 || mode.diameters > 200) {
        refuse(name + "expected 0 to 200 diameters", mode.diameters);
    }
    if (mode.weights.size() != places) {
        refuse(name + "expected as many weights as places",
               static_cast<double>(mode.weights.size()));
    }
    if (!(std::abs(mode.heard) <= 1e6)) {
        refuse(name + "expected to be heard with a weight from -1e6 to 1e6", mode.heard);
    }
    for (const double weight : mode.weights) {
        if (!(std::abs(weight) <= 1e6)) {
            refuse(name + "expected weights from -1e6 to 1e6", weight);
        }
    }
}

/// Lagrange's polynomial through up to four neighbours.
struct Between {
    std::size_t first = 0;
    std::size_t count = 1;
    std::array<double, 4> share{1.0};

    Between(const std::vector<double>& places, double at) {
        at = std::clamp(at, places.front(), places.back());
        count = std::min<std::size_t>(4, places.size());
        const auto above = static_cast<std::size_t>(
            std::upper_bound(places.begin(), places.end(), at) - places.begin());
        first = std::min(above >= 2 ? above - 2 : 0, places.size() - count);
        for (std::size_t i = 0; i < count; ++i) {
            share[i] = 1.0;
            for (std::size_t j = 0; j < count; ++j) {
                const double other = places[first + j];
                share[i] *= j == i ? 1.0 : (at - other) / (places[first + i] - other);
            }
        }
    }
};

}  // namespace

void check(const GivenModes& given) {
    if (!(std::isfinite(given.radius) && given.radius > 0.0)) {
        refuse("modes: expected a radius above 0 [m]", given.radius);
    }
    check_places(given.places);
    for (std::size_t k = 0; k < given.modes.size(); ++k) {
        check_mode(given.modes[k], k, given.places.size());
    }
    const std::size_t count = sounding_modes(given);
    if (count < 1 || count > kMostModes) {
        refuse("modes: expected 1 to " + std::to_string(kMostModes) + " modes",
               static_cast<double>(count));
    }
}

std::size_t sounding_modes(const GivenModes& given) {
    std::size_t count = 0;
    for (const auto& mode : given.modes) {
        count += mode.diameters > 0 ? 2 : 1;
    }
    return count;
}

void evaluate_weights(const GivenModes& given, const Spot& spot,
                      std::span<double> values) noexcept {
    const bool on_head = spot.r <= given.radius;
    const Between between(given.places, spot.r / given.radius);
    std::size_t k = 0;
    for (const auto& mode : given.modes) {
        double weight = 0.0;
        for (std::size_t i = 0; on_head && i < between.count; ++i) {
            weight += between.share[i] * mode.weights[between.first + i];
        }
        const double angle = mode.diameters * spot.theta;
        values[k++] = weight * std::cos(angle);
        if (mode.diameters > 0) {
            values[k++] = weight * std::sin(angle);
        }
    }
}

void heard_weights(const GivenModes& given, std::span<double> values) noexcept {
    std::size_t k = 0;
    for (const auto& mode : given.modes) {
        values[k++] = mode.heard;
        if (mode.diameters > 0) {
            values[k++] = mode.heard;
        }
    }
}

}  // namespace percussionist::modal
