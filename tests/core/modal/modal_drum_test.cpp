#include "core/modal/modal_drum.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

using namespace percussionist::modal;

namespace {

constexpr double kRate = 48000;

struct Event {
    std::size_t sample;
    Stroke stroke;
};

/// Strokes at absolute samples, rendered in blocks of one size.
std::vector<double> played(const std::vector<Event>& events, std::size_t length, std::size_t block,
                           const DrumSettings& settings = {}) {
    ModalDrum drum(settings, kRate);
    std::vector<double> out(length);
    for (std::size_t start = 0; start < length; start += block) {
        const std::size_t size = std::min(block, length - start);
        for (const auto& event : events) {
            if (event.sample >= start && event.sample < start + size) {
                REQUIRE(drum.strike(event.sample - start, event.stroke));
            }
        }
        drum.process(std::span(out).subspan(start, size));
    }
    return out;
}

double peak(const std::vector<double>& sound) {
    double most = 0.0;
    for (const double sample : sound) {
        most = std::max(most, std::abs(sample));
    }
    return most;
}

/// Mean frequency weighted by energy [Hz]: how bright it is.
double centroid(const std::vector<double>& sound) {
    double power = 0.0, slope = 0.0;
    for (std::size_t i = 1; i < sound.size(); ++i) {
        power += sound[i] * sound[i];
        slope += (sound[i] - sound[i - 1]) * (sound[i] - sound[i - 1]);
    }
    return std::sqrt(slope / power) * kRate / (2 * std::numbers::pi);
}

}  // namespace

TEST_CASE("a stroke of 2 m/s on the default drum peaks near 0.3") {
    const auto sound = played({{0, {}}}, 48000, 64);
    CHECK(peak(sound) > 0.25);
    CHECK(peak(sound) < 0.35);
}

TEST_CASE(
    "a stroke starts at its very sample, and sounds the same wherever and in whatever blocks") {
    const std::size_t length = 20000;
    const auto reference = played({{0, {}}, {700, {.velocity = 1}}}, length, length);
    CHECK(reference[0] != 0.0);
    for (const std::size_t block : {1u, 17u, 64u, 1024u}) {
        for (const std::size_t shift : {0u, 1u, 63u, 1000u}) {
            const auto sound =
                played({{shift, {}}, {shift + 700, {.velocity = 1}}}, length + shift, block);
            CHECK(std::all_of(sound.begin(), sound.begin() + static_cast<long>(shift),
                              [](double x) { return x == 0.0; }));
            CHECK(std::equal(reference.begin(), reference.end(),
                             sound.begin() + static_cast<long>(shift)));
        }
    }
}

TEST_CASE("the harder the stroke, the louder and the brighter") {
    double level = 0.0, brightness = 0.0;
    for (const double velocity : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        const auto sound = played({{0, {.velocity = velocity}}}, 9600, 64);
        CHECK(peak(sound) > 1.2 * level);
        CHECK(centroid(sound) > 1.02 * brightness);
        level = peak(sound);
        brightness = centroid(sound);
    }
}

TEST_CASE("the sound has no part at 0 Hz, and ends in silence that is exactly 0") {
    const auto sound = played({{0, {}}}, 48000 * 8, 64);
    double sum = 0.0;
    for (const double sample : sound) {
        sum += sample;
    }
    CHECK(std::abs(sum / kRate) < 1e-4 * peak(sound));
    CHECK(sound.back() == 0.0);
    ModalDrum drum({}, kRate);
    CHECK(drum.silent());
}

TEST_CASE("what is heard rings at the frequencies of theory") {
    const auto sound = played({{0, {}}}, 48000, 64);
    const auto modes = membrane_modes({}, 6);
    const auto level_at = [&](double w) {
        double re = 0.0, im = 0.0;
        for (std::size_t i = 2400; i < sound.size(); ++i) {
            const double t = static_cast<double>(i) / kRate;
            re += sound[i] * std::cos(w * t);
            im += sound[i] * std::sin(w * t);
        }
        return std::hypot(re, im);
    };
    for (const std::size_t k : {0u, 1u, 3u, 5u}) {
        const double w = modes[k].angular_frequency;
        CHECK(level_at(w) > level_at(w * 1.004));
        CHECK(level_at(w) > level_at(w / 1.004));
        CHECK(level_at(w) > 3 * level_at(w * 1.12));
    }
}

TEST_CASE("nothing makes it leave -1 to 1") {
    std::vector<Event> events;
    for (std::size_t i = 0; i < 200; ++i) {
        const double n = static_cast<double>(i);
        events.push_back({i * 97,
                          {.velocity = 100,
                           .r = 0.33 * (n / 200),
                           .theta = n,
                           .mallet = {.mass = 1e-4 * std::pow(1.1, n), .stiffness = 1e10}}});
    }
    const auto sound = played(events, 48000, 64);
    CHECK(std::all_of(sound.begin(), sound.end(), [](double x) { return std::abs(x) <= 1.0; }));
    CHECK(peak(sound) > 0.6);
}

TEST_CASE("a drum tuned while it sounds neither clicks nor dies") {
    ModalDrum drum({}, kRate);
    drum.strike(0, {});
    std::vector<double> sound(480);
    double step = 0.0;
    std::vector<double> all;
    for (int i = 0; i < 40; ++i) {
        drum.process(std::span(sound));
        all.insert(all.end(), sound.begin(), sound.end());
    }
    for (std::size_t i = 4800; i < all.size(); ++i) {
        step = std::max(step, std::abs(all[i] - all[i - 1]));
    }
    for (int i = 0; i < 40; ++i) {
        const double last = sound.back();
        drum.tune(Membrane{.tension = 3500.0 + 50 * i}, Decay{});
        drum.process(std::span(sound));
        CHECK(std::abs(sound[0] - last) < 1.5 * step);
    }
    CHECK(std::abs(sound[0]) > 0.0);
    drum.tune(Membrane{.radius = 0.2}, Decay{});
    drum.choose({.count = 64});
    drum.process(std::span(sound));
    drum.choose({.count = 1000});
    drum.process(std::span(sound));
    drum.choose({.count = 1});
    drum.process(std::span(sound));
    drum.choose({.count = 500});
    drum.set_pickup(0, {.r = 0.05, .theta = 1.0});
    drum.process(std::span(sound));
    CHECK(std::all_of(sound.begin(), sound.end(), [](double x) { return std::isfinite(x); }));
    CHECK(!drum.silent());
}

TEST_CASE("a hand mutes it until the next stroke") {
    ModalDrum drum({}, kRate);
    std::vector<double> sound(9600);
    const auto play = [&] {
        drum.process(std::span(sound));
        return peak(std::vector(sound.end() - 2400, sound.end()));
    };
    drum.strike(0, {});
    const double open = play();
    drum.mute(0.05);
    CHECK(play() < 1e-4 * open);
    drum.strike(0, {});
    CHECK(play() == doctest::Approx(open).epsilon(0.01));
}

TEST_CASE("more strokes than mallets and than places in the queue do no harm") {
    ModalDrum drum({}, kRate);
    for (std::size_t i = 0; i < ModalDrum::kQueue; ++i) {
        CHECK(drum.strike(0, {.r = 0.005 * static_cast<double>(i)}));
    }
    CHECK_FALSE(drum.strike(0, {}));
    std::vector<double> sound(4800);
    drum.process(std::span(sound));
    CHECK(std::all_of(sound.begin(), sound.end(), [](double x) { return std::abs(x) <= 1.0; }));
    drum.reset();
    CHECK(drum.silent());
}

TEST_CASE("a stroke that cannot be is refused and changes nothing") {
    ModalDrum drum({}, kRate);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(drum.strike(0, {.velocity = 0}), std::invalid_argument);
    CHECK_THROWS_AS(drum.strike(0, {.velocity = nan}), std::invalid_argument);
    CHECK_THROWS_AS(drum.strike(0, {.r = -1}), std::invalid_argument);
    CHECK_THROWS_AS(drum.strike(0, {.theta = nan}), std::invalid_argument);
    CHECK_THROWS_AS(drum.strike(0, {.mallet = {.mass = 0}}), std::invalid_argument);
    CHECK_THROWS_AS(drum.choose({.count = 0}), std::invalid_argument);
    CHECK_THROWS_AS(drum.mute(0), std::invalid_argument);
    CHECK_THROWS_AS(drum.tune(Membrane{.tension = nan}, Decay{}), std::invalid_argument);
    CHECK(drum.silent());
    CHECK(std::get<Membrane>(drum.settings().body).tension == 3500.0);
}
