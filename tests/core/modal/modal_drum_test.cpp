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

TEST_CASE("what dies away comes to rest before its numbers become subnormal") {
    for (const bool hand : {false, true}) {
        ModalDrum drum({.loss = Decay{.t60_low = 0.4, .t60_high = 0.01}, .choice = {.count = 24}},
                       kRate);
        if (hand) {
            drum.lay(0, {});
        }
        drum.strike(0, {});
        std::array<float, 64> block{};
        for (int i = 0; i < 1500; ++i) {
            drum.process(std::span(block));
            for (const float sample : block) {
                REQUIRE(std::fpclassify(sample) != FP_SUBNORMAL);
            }
            const auto& bank = drum.head().bank();
            Values only(bank.padded(), 0.0);
            for (std::size_t k = 0; k < bank.size(); ++k) {
                only[k] = 1.0;
                REQUIRE(std::fpclassify(bank.displacement(only)) != FP_SUBNORMAL);
                only[k] = 0.0;
            }
        }
        CHECK(drum.silent());
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

TEST_CASE("a hand laid on a ringing drum brings it to rest, and leaves it without a sound") {
    for (const double pressure : {300.0, 3000.0, 2e4}) {
        for (const std::size_t when : {1022u, 1109u, 1330u}) {
            ModalDrum drum({.pickups = {{.hears = Pickup::Hears::position}}}, kRate);
            drum.strike(0, {.velocity = 5});
            std::vector<double> sound(static_cast<std::size_t>(6 * kRate));
            drum.process(std::span(sound).first(when));
            drum.lay(0, {.pressure = pressure});
            drum.process(std::span(sound));
            CAPTURE(pressure);
            CAPTURE(when);
            CHECK(drum.silent());
            CHECK(sound.back() == 0.0);
            drum.lay(0, {.pressure = 0.0});
            drum.process(std::span(sound));
            CHECK(peak(sound) == 0.0);
        }
    }
}

TEST_CASE("a hand on a drum at rest damps the next stroke alike, whatever was set meanwhile") {
    const auto damped = [](auto set) {
        ModalDrum drum({}, kRate);
        drum.lay(0, {});
        set(drum);
        drum.strike(0, {});
        std::vector<double> sound(4800);
        drum.process(std::span(sound));
        return sound;
    };
    const auto reference = damped([](ModalDrum&) {});
    CHECK(damped([](ModalDrum& drum) { drum.reset(); }) == reference);
    CHECK(damped([](ModalDrum& drum) { drum.tune(Membrane{}, Decay{}); }) == reference);
    CHECK(damped([](ModalDrum& drum) { drum.set_pickup(0, {}); }) == reference);
    CHECK(damped([](ModalDrum& drum) { drum.mute(1.0); }) == reference);
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

namespace {

/// A drum played through all its signals; what its pickups hear.
std::vector<std::vector<double>> heard(ModalDrum& drum, std::size_t length, std::size_t block,
                                       const std::vector<double>& force,
                                       const std::vector<double>& position) {
    std::vector<std::vector<double>> out(drum.settings().pickups.size(),
                                         std::vector<double>(length));
    for (std::size_t start = 0; start < length; start += block) {
        std::vector<double*> outputs;
        for (auto& signal : out) {
            outputs.push_back(signal.data() + start);
        }
        drum.process(
            DrumSignals<double>{.outputs = outputs,
                                .size = std::min(block, length - start),
                                .force = force.empty() ? nullptr : force.data() + start,
                                .position = position.empty() ? nullptr : position.data() + start});
    }
    return out;
}

}  // namespace

TEST_CASE("forces, followers, slides, hands and several pickups sound the same in any blocks") {
    const std::size_t length = 12000;
    std::vector<double> force(length, 0.0), position(length, 0.05);
    for (std::size_t n = 3000; n < 3100; ++n) {
        force[n] = -5;
    }
    for (std::size_t n = 6000; n < 7000; ++n) {
        position[n] = 0.004 * std::cos(2 * std::numbers::pi * static_cast<double>(n) / 1000);
    }
    const Mallet glass{.stiffness = 1e11, .exponent = 1.5, .dissipation = 20};
    const auto played_in = [&](std::size_t block, double stretch) {
        ModalDrum drum({.body = Membrane{.stretch = stretch},
                        .pickups = {{},
                                    {.hears = Pickup::Hears::position},
                                    {.hears = Pickup::Hears::pressure}}},
                       kRate);
        drum.lay(0, {.r = 0.2, .area = 1e-4, .pressure = 500});
        drum.follow(0.1, 0.5, {});
        drum.force_at(0.1, 2.0);
        drum.strike(100, {.slide_x = 3.0});
        drum.strike(400, {.mallet = glass});
        return heard(drum, length, block, force, position);
    };
    for (const double stretch : {0.0, 3e5}) {
        const auto reference = played_in(length, stretch);
        for (const auto& signal : reference) {
            CHECK(peak(signal) > 0.01);
            CHECK(peak(signal) <= 1.0);
        }
        CHECK(played_in(1000, stretch) == reference);
        CHECK(played_in(100, stretch) == reference);
    }
}

TEST_CASE("another pickup, body or number of modes is faded in: nothing clicks") {
    const auto largest_step = [](const std::vector<double>& sound, std::size_t from,
                                 std::size_t to) {
        double most = 0.0;
        for (std::size_t i = from; i < to; ++i) {
            most = std::max(most, std::abs(sound[i] - sound[i - 1]));
        }
        return most;
    };
    for (int change = 0; change < 6; ++change) {
        ModalDrum drum({.choice = {.count = 100}}, kRate);
        drum.strike(0, {});
        std::vector<double> sound(4800);
        drum.process(std::span(sound).first(2400));
        const double before = largest_step(sound, 1200, 2400);
        change == 0   ? drum.set_pickup(0, {.r = 0.05, .theta = 5.0})
        : change == 1 ? drum.choose({.count = 10, .skip = 0})
        : change == 2 ? drum.choose({.count = 300, .skip = 4})
        : change == 3 ? drum.tune(Membrane{.radius = 0.25}, Decay{})
        : change == 4 ? drum.tune(Plate{}, Decay{})
                      : drum.tune(Membrane{.tension = 500}, Decay{});
        drum.process(std::span(sound).last(2400));
        CAPTURE(change);
        CHECK(largest_step(sound, 2400, 2500) < 1.5 * before + 0.02);
        CHECK(peak({sound.end() - 1000, sound.end()}) > 0.0);
    }
}

TEST_CASE("a mode is 80 dB down when it is struck, or heard, on its node") {
    const auto level_of = [](double r, double theta, double pickup_r, double pickup_theta,
                             std::size_t k) {
        ModalDrum drum({.pickups = {{.r = pickup_r, .theta = pickup_theta}}}, kRate);
        drum.strike(0, {.r = r, .theta = theta});
        std::vector<double> sound(96000);
        drum.process(std::span(sound));
        const double w = membrane_modes({}, 20)[k].angular_frequency;
        double re = 0.0, im = 0.0;
        for (std::size_t i = 4800; i < sound.size(); ++i) {
            const double t = static_cast<double>(i) / kRate;
            const double hann =
                1 - std::cos(2 * std::numbers::pi * static_cast<double>(i - 4800) / 91200);
            re += hann * sound[i] * std::cos(w * t);
            im += hann * sound[i] * std::sin(w * t);
        }
        return std::hypot(re, im);
    };
    // Mode 1: one diameter, cosine: still along theta = pi / 2.
    const double quarter = std::numbers::pi / 2;
    const double open = level_of(0.15, 0.0, 0.15, 0.0, 1);
    CHECK(level_of(0.15, quarter, 0.15, 0.0, 1) < 1e-4 * open);
    CHECK(level_of(0.15, 0.0, 0.15, quarter, 1) < 1e-4 * open);
}

TEST_CASE("modes given outright ring at their frequencies, pairs turned against each other") {
    GivenModes given;
    given.places = {0.0, 0.5, 1.0};
    given.modes = {{200, 1.0, 0, {8, 4, 0}}, {331, 0.8, 1, {0, 6, 0}}};
    ModalDrum drum({.body = given}, kRate);
    CHECK(drum.head().resonator().size() == 3);
    drum.strike(0, {.r = 0.1});
    std::vector<double> sound(24000);
    drum.process(std::span(sound));
    CHECK(peak(sound) > 0.01);
    drum.tune(Membrane{}, Decay{});
    drum.process(std::span(sound));
    CHECK(drum.head().resonator().size() == 240);
    CHECK(std::all_of(sound.begin(), sound.end(), [](double x) { return std::abs(x) <= 1.0; }));
}

TEST_CASE("loops for any processor and the best give the same bits") {
    ModeBank plain(100, 1 / kRate, ModeLoops::baseline()), best(100, 1 / kRate, ModeLoops::best());
    Values phi(plain.padded(), 0.0);
    for (std::size_t k = 0; k < 100; ++k) {
        const double n = static_cast<double>(k);
        plain.set(k, {300 + 71 * n, 3 + n, 0.02});
        best.set(k, {300 + 71 * n, 3 + n, 0.02});
        phi[k] = std::cos(n * n);
    }
    ModeBank::Weights weights{phi, phi, {}};
    std::array<double, ModeBank::kChunk> a{}, b{};
    Values plain_middle(plain.padded()), best_middle(best.padded());
    for (const std::size_t samples : {1u, 16u, 37u, 64u}) {
        plain.give(std::vector(samples, 1.7), phi);
        best.give(std::vector(samples, 1.7), phi);
        CHECK(plain.displacement(phi) == best.displacement(phi));
        CHECK(plain.reading(weights) == best.reading(weights));
        CHECK(plain.swing_about(phi, plain_middle) == best.swing_about(phi, best_middle));
        CHECK(plain_middle == best_middle);
        plain.ring(weights, a);
        best.ring(weights, b);
        CHECK(a == b);
        plain.answer(phi, weights, a);
        best.answer(phi, weights, b);
        CHECK(a == b);
        plain.advance(samples);
        best.advance(samples);
    }
    CHECK(plain.energy() == best.energy());
}
