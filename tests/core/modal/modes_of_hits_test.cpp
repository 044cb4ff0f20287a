#include "core/modal/modes_of_hits.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "core/modal/decay.hpp"
#include "core/modal/mode_file.hpp"

using namespace percussionist::modal;
using std::numbers::pi;

namespace {

constexpr double kRate = 48000;

/// Sixteen modes of a small drum, with weights that change their sign.
GivenModes sixteen() {
    GivenModes given;
    given.places = {0.0, 0.2, 0.4, 0.6, 0.8, 0.95};
    const double ratios[] = {1.0,    1.5933, 2.1355, 2.2954, 2.6531, 2.9173, 3.1555, 3.5001,
                             3.5985, 3.6475, 4.0589, 4.1317, 4.2305, 4.6010, 4.8319, 4.9033};
    const int m[] = {0, 1, 2, 0, 3, 1, 4, 2, 0, 5, 3, 6, 1, 4, 7, 2};
    for (int k = 0; k < 16; ++k) {
        GivenMode mode;
        mode.frequency = 110 * ratios[k];
        mode.t60 = 1.4 / (1 + 0.02 * k * k);
        for (const double place : given.places) {
            const double x = 2.4048 * ratios[k] * place;
            mode.weights.push_back(std::cyl_bessel_j(static_cast<double>(m[k]), x) + 0.02);
        }
        mode.heard = 1.0 / (1 + 0.1 * k);
        given.modes.push_back(mode);
    }
    return given;
}

/// Struck at each place by an impulse, heard with noise `decibels` below, the strokes beginning at
/// different instants.
std::vector<Hit> recorded(const GivenModes& given, double decibels) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < given.places.size(); ++i) {
        Hit hit{given.places[i], std::vector<double>(72000, 0.0)};
        const std::size_t start = 2400 + 100 * i;
        for (const auto& mode : given.modes) {
            const double loss = loss_of_t60(mode.t60);
            for (std::size_t n = start; n < hit.samples.size(); ++n) {
                const double t = static_cast<double>(n - start) / kRate;
                hit.samples[n] += mode.weights[i] * mode.heard * std::exp(-loss * t) *
                                  std::cos(2 * pi * mode.frequency * t);
            }
        }
        double power = 0.0;
        for (std::size_t n = start; n < start + 24000; ++n) {
            power += hit.samples[n] * hit.samples[n] / 24000;
        }
        const double noise = std::sqrt(power) * std::pow(10, -decibels / 20);
        for (double& x : hit.samples) {
            x += noise * normal(random);
        }
        hits.push_back(std::move(hit));
    }
    return hits;
}

}  // namespace

TEST_CASE("modes are measured at 30 dB above noise: frequencies, decays, weights and their signs") {
    const auto given = sixteen();
    const auto hits = recorded(given, 30);
    const auto measured = modes_of_hits(hits, kRate, {.low = 50, .high = 700});
    double worst_frequency = 0.0, worst_decay = 0.0, worst_weight = 0.0;
    CHECK(measured.modes.modes.size() >= 16);
    CHECK(measured.modes.modes.size() <= 18);
    for (const auto& mode : given.modes) {
        const auto found =
            std::min_element(measured.modes.modes.begin(), measured.modes.modes.end(),
                             [&](const auto& a, const auto& b) {
                                 return std::abs(a.frequency - mode.frequency) <
                                        std::abs(b.frequency - mode.frequency);
                             });
        worst_frequency =
            std::max(worst_frequency, std::abs(found->frequency / mode.frequency - 1));
        worst_decay = std::max(worst_decay, std::abs(found->t60 / mode.t60 - 1));
        // Scaled alike, and the first place positive.
        double most = 0.0, found_most = 0.0;
        for (std::size_t i = 0; i < given.places.size(); ++i) {
            most = std::max(most, std::abs(mode.weights[i]));
            found_most = std::max(found_most, std::abs(found->weights[i]));
        }
        for (std::size_t i = 0; i < given.places.size(); ++i) {
            const double weight = mode.weights[i] / most;
            const double answer = found->weights[i] / found_most;
            if (std::abs(weight) > 0.2) {
                CAPTURE(mode.frequency);
                CAPTURE(i);
                CHECK(weight * answer > 0.0);
                worst_weight =
                    std::max(worst_weight, std::abs(20 * std::log10(std::abs(answer / weight))));
            }
        }
    }
    MESSAGE("frequency " << worst_frequency << " decay " << worst_decay << " weight "
                         << worst_weight << " dB");
    CHECK(worst_frequency < 0.002);
    CHECK(worst_decay < 0.05);
    CHECK(worst_weight < 1.0);
    for (const double left : measured.left) {
        CHECK(left < 0.01);
    }
}

TEST_CASE("modes are told apart in a quarter of a second, as of a bass drum in a beat") {
    GivenModes given;
    given.places = {0.0, 0.5};
    given.modes = {{.frequency = 46, .t60 = 0.40, .weights = {1.0, 0.6}, .heard = 1.0},
                   {.frequency = 58, .t60 = 0.30, .weights = {0.8, -0.5}, .heard = 1.0},
                   {.frequency = 84, .t60 = 0.20, .weights = {0.6, 0.6}, .heard = 1.0},
                   {.frequency = 110, .t60 = 0.30, .weights = {0.4, 0.5}, .heard = 1.0},
                   {.frequency = 138, .t60 = 0.15, .weights = {0.4, 0.5}, .heard = 1.0}};
    auto hits = recorded(given, 30);
    for (auto& hit : hits) {
        hit.samples.resize(15000);
    }
    const auto measured = modes_of_hits(hits, kRate, {.high = 1000});
    for (const auto& mode : given.modes) {
        CAPTURE(mode.frequency);
        CHECK(std::any_of(measured.modes.modes.begin(), measured.modes.modes.end(),
                          [&](const GivenMode& found) {
                              return std::abs(found.frequency / mode.frequency - 1) < 0.01 &&
                                     std::abs(found.t60 / mode.t60 - 1) < 0.1;
                          }));
    }
    for (const double left : measured.left) {
        CHECK(left < 0.03);
    }
}

TEST_CASE("recordings that cannot be are refused with the reason") {
    const auto refused = [](std::vector<Hit> hits) {
        try {
            modes_of_hits(hits, kRate, {});
        } catch (const std::invalid_argument& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    CHECK(refused({}).find("at least one") != std::string::npos);
    CHECK(refused({{0.0, std::vector<double>(100, 1.0)}}).find("shorter") != std::string::npos);
    CHECK(refused({{0.0, std::vector<double>(9600, 0.0)}}).find("silent") != std::string::npos);
    CHECK(refused({{2.0, std::vector<double>(9600, 1.0)}}).find("places") != std::string::npos);
    CHECK(refused({{0.0, std::vector<double>(9600, std::nan(""))}}).find("no numbers") !=
          std::string::npos);
}
