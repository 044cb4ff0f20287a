#include "core/listening/live_listener.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/listening/practice/dice.hpp"

using namespace percussionist::listening;

namespace {

struct Told {
    LiveEvent event;
    double at = 0.0;  ///< when it was told [s]
};

std::vector<Told> listen(LiveListener& listener, const std::vector<float>& signal, double rate,
                         std::size_t block) {
    std::vector<Told> told;
    std::size_t n = 0;
    while (n < signal.size()) {
        const std::size_t size = std::min(block, signal.size() - n);
        listener.process({signal.data() + n, size},
                         [&](const LiveEvent& event, std::size_t samples) {
                             told.push_back({event, static_cast<double>(n + samples) / rate});
                         });
        n += size;
    }
    return told;
}

/// Kicks (even) and bursts of noise (odd), every 0.4 s from 0.5 s on.
std::vector<float> strokes(double rate, int count) {
    practice::Dice dice(2);
    std::vector<float> out(static_cast<std::size_t>((0.7 + 0.4 * count) * rate), 0.0F);
    for (int k = 0; k < count; ++k) {
        const auto from = static_cast<std::size_t>((0.5 + 0.4 * k) * rate);
        for (std::size_t n = 0; n < static_cast<std::size_t>(0.3 * rate); ++n) {
            const double t = static_cast<double>(n) / rate;
            const double kick =
                std::exp(-t / 0.07) *
                std::sin(2.0 * std::numbers::pi * (55.0 * t + 2.5 * (1.0 - std::exp(-t / 0.02))));
            const double hiss = std::exp(-t / 0.05) * dice.uniform(-1.0, 1.0);
            out[from + n] += static_cast<float>(0.5 * (k % 2 == 0 ? kick : hiss));
        }
    }
    return out;
}

}  // namespace

TEST_CASE("an attack is told within 12 ms of its sound, its drum within 60 ms") {
    for (const double rate : {44100.0, 48000.0, 96000.0}) {
        LiveListener listener({.rate = rate}, learnt_drums());
        const auto told = listen(listener, strokes(rate, 12), rate, 64);
        int attacks = 0, drums = 0;
        for (const Told& t : told) {
            const double after = std::fmod(t.at - 0.5 + 1e-9, 0.4);
            if (t.event.kind == LiveEvent::Kind::attack) {
                ++attacks;
                CHECK(after < 0.012);
            } else {
                ++drums;
                CHECK(after < 0.060);
                CHECK(std::abs(std::remainder(t.event.time - 0.504, 0.4)) < 0.006);
            }
        }
        CHECK(attacks == 12);
        CHECK(drums >= 10);
    }
}

TEST_CASE("the size of blocks does not matter") {
    const auto signal = strokes(48000.0, 8);
    LiveListener small({}, learnt_drums()), large({}, learnt_drums());
    const auto one = listen(small, signal, 48000.0, 16),
               other = listen(large, signal, 48000.0, 4096);
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(one[i].event.time == other[i].event.time);
        CHECK(one[i].event.confidence == other[i].event.confidence);
    }
}

TEST_CASE("drums learnt from four strokes each are told apart, and a drum not learnt is not") {
    LiveListener listener({}, learnt_drums());
    OwnDrums drums;
    const std::size_t low = *drums.named("low");
    listener.set_own_drums(drums);
    listener.learn(low, 4);
    std::vector<float> kicks, hisses;
    const auto all = strokes(48000.0, 12);
    for (int k = 0; k < 12; ++k) {
        const auto from = all.begin() + static_cast<std::ptrdiff_t>((0.4 + 0.4 * k) * 48000.0);
        auto& to = k % 2 == 0 ? kicks : hisses;
        to.insert(to.end(), from, from + 19200);
    }
    listen(listener, kicks, 48000.0, 64);
    CHECK(!listener.learning());
    const auto own = [](const std::vector<Told>& told) {
        return std::count_if(told.begin(), told.end(), [](const Told& t) {
            return t.event.kind == LiveEvent::Kind::own_drum;
        });
    };
    CHECK(own(listen(listener, hisses, 48000.0, 64)) == 0);
    CHECK(own(listen(listener, kicks, 48000.0, 64)) == 6);
}

TEST_CASE("other drums end the learning, which touches none of them") {
    LiveListener listener({}, learnt_drums());
    OwnDrums drums;
    listener.set_own_drums(drums);
    listener.learn(*drums.named("low"), 3);
    OwnDrums others;
    OwnDrum& other = others[*others.named("other")];
    other.strokes = 4;
    listener.set_own_drums(others);
    CHECK(!listener.learning());
    listen(listener, strokes(48000.0, 6), 48000.0, 64);
    CHECK(to_text(listener.own_drums()) == to_text(others));
}

TEST_CASE("an echo far softer than the stroke is not learnt as one, nor told as that drum") {
    LiveListener listener({}, learnt_drums());
    OwnDrums drums;
    const std::size_t kick = *drums.named("kick");
    listener.set_own_drums(drums);
    listener.learn(kick, 3);
    const auto once = strokes(48000.0, 10);
    auto echoed = once;
    for (std::size_t n = 7200; n < echoed.size(); ++n) echoed[n] += 0.03F * once[n - 7200];
    int told_own = 0;
    for (int stroke = 0; stroke < 5; ++stroke) {
        for (const Told& t :
             listen(listener, {echoed.begin(), echoed.begin() + 43200}, 48000.0, 64))
            told_own += t.event.kind == LiveEvent::Kind::own_drum ? 1 : 0;
    }
    CHECK(listener.own_drums()[kick].strokes == 3);
    CHECK(told_own == 2);
}

TEST_CASE("silence and what is no number do no harm") {
    LiveListener listener({}, learnt_drums());
    CHECK(listen(listener, std::vector<float>(48000, 0.0F), 48000.0, 64).empty());
    listen(listener, std::vector<float>(4800, NAN), 48000.0, 64);
    CHECK(listen(listener, strokes(48000.0, 8), 48000.0, 64).size() >= 8);
}

TEST_CASE("a moment of samples beyond all bounds is soon forgotten") {
    for (const float huge : {1e3F, 1e15F, 1e25F, 3e38F, INFINITY}) {
        LiveListener listener({}, learnt_drums());
        std::vector<float> burst(64, huge);
        for (std::size_t n = 0; n < burst.size(); n += 2) burst[n] = -huge;
        listen(listener, burst, 48000.0, 64);
        const auto told = listen(listener, strokes(48000.0, 8), 48000.0, 64);
        CAPTURE(huge);
        CHECK(std::count_if(told.begin(), told.end(), [](const Told& t) {
                  return t.at > 0.5 && t.event.kind == LiveEvent::Kind::attack;
              }) == 8);
    }
}
