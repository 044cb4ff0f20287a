#include "core/modal/drum_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace percussionist::modal {

namespace {

constexpr double kAir = 1.2;  // [kg/m^3]
constexpr std::size_t kPlaces = 21;
constexpr double kElevation = 0.6;  // [rad]

std::vector<DrumOfSet> make_set() {
    return {
        {"bodhran", "goat skin on a frame of 18 inches, open at the back",
         Membrane{.radius = 0.2286,
                  .tension = 2000,
                  .surface_density = 0.40,
                  .bending = 0.02,
                  .air_density = kAir},
         Decay{.t60_low = 0.8, .t60_high = 0.12}},
        {"timpani", "Mylar of 0.25 mm on a kettle of 26 inches and 0.14 m^3",
         Membrane{.radius = 0.33,
                  .tension = 4200,
                  .surface_density = 0.348,
                  .bending = 0.005,
                  .air_density = kAir,
                  .cavity = 0.14},
         Decay{.t60_low = 4.0, .t60_high = 0.4}},
        {"tom-high", "Mylar of 0.19 mm, 12 inches, open at the bottom",
         Membrane{.radius = 0.1524,
                  .tension = 1900,
                  .surface_density = 0.262,
                  .bending = 0.002,
                  .air_density = kAir,
                  .stretch = 5e5},
         Decay{.t60_low = 0.9, .t60_high = 0.15}},
        {"tom-low", "Mylar of 0.19 mm, 16 inches, open at the bottom",
         Membrane{.radius = 0.2032,
                  .tension = 1500,
                  .surface_density = 0.262,
                  .bending = 0.002,
                  .air_density = kAir,
                  .stretch = 5e5},
         Decay{.t60_low = 1.2, .t60_high = 0.15}},
        {"snare",
         "a snare drum's batter head of 14 inches, its shell of 12 litres closed, snares off",
         Membrane{.radius = 0.1778,
                  .tension = 3800,
                  .surface_density = 0.262,
                  .bending = 0.002,
                  .air_density = kAir,
                  .cavity = 0.012},
         Decay{.t60_low = 0.6, .t60_high = 0.1}},
        {"bass", "a bass drum's batter head of 22 inches, its shell of 110 litres closed",
         Membrane{.radius = 0.2794,
                  .tension = 900,
                  .surface_density = 0.348,
                  .bending = 0.005,
                  .air_density = kAir,
                  .cavity = 0.11},
         Decay{.t60_low = 0.7, .t60_high = 0.06, .high_frequency = 1000}},
        {"cymbal", "a flat plate of bronze, 16 inches, 1 mm, its edge free", Plate{},
         PhysicalLoss{.constant = 1.2, .quadratic = 4e-9}},
        {"splash", "a flat plate of bronze, 10 inches, 0.7 mm, its edge free",
         Plate{.radius = 0.127, .thickness = 0.0007},
         PhysicalLoss{.constant = 3, .quadratic = 6e-9}},
    };
}

/// Six digits are enough for a drum that nobody has measured, and keep its file short.
double rounded(double value) {
    if (value == 0.0) {
        return value;
    }
    const double scale = std::min(1e7, std::pow(10, 5 - std::floor(std::log10(std::abs(value)))));
    return std::round(value * scale) / scale;
}

}  // namespace

std::span<const DrumOfSet> drum_set() {
    static const std::vector<DrumOfSet> set = make_set();
    return set;
}

const DrumOfSet& drum_of_set(const std::string& name) {
    std::string names;
    for (const auto& drum : drum_set()) {
        if (drum.name == name) {
            return drum;
        }
        names += (names.empty() ? "" : ", ") + drum.name;
    }
    throw std::invalid_argument("no drum '" + name + "'; there are: " + names);
}

GivenModes computed_modes(const DrumOfSet& drum, std::size_t count) {
    const Resonator resonator(drum.body, drum.loss, {.count = count});
    GivenModes given;
    given.name = drum.name;
    given.origin = "computed: " + drum.what;
    given.radius = resonator.radius();
    given.places.clear();
    for (std::size_t i = 0; i < kPlaces; ++i) {
        given.places.push_back(static_cast<double>(i) / (kPlaces - 1));
    }
    const auto modes = resonator.round();
    for (std::size_t k = 0; k < modes.size(); ++k) {
        if (modes[k].sine) {
            continue;
        }
        const auto& oscillator = resonator.mode(k);
        const double w = oscillator.angular_frequency, s = oscillator.loss;
        const double one_kilogram = 1 / std::sqrt(oscillator.mass);
        GivenMode mode;
        mode.frequency = rounded(std::sqrt(w * w - s * s) / (2 * std::numbers::pi));
        mode.t60 = rounded(loss_of_t60(1.0) / s);
        mode.diameters = modes[k].diameters;
        for (const double place : given.places) {
            mode.weights.push_back(
                rounded(one_kilogram * modes[k].shape(place * given.radius, 0.0)));
        }
        mode.heard = rounded(kAir / (2 * std::numbers::pi) * one_kilogram * w *
                             radiation(modes[k], kElevation, 0.0));
        given.modes.push_back(mode);
    }
    return given;
}

}  // namespace percussionist::modal
