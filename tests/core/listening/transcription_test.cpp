#include "core/listening/transcription.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/listening/judgement.hpp"
#include "core/listening/onset_match.hpp"
#include "core/listening/practice/dice.hpp"
#include "core/listening/practice/piece_of_music.hpp"
#include "core/listening/practice/speech.hpp"

using namespace percussionist::listening;

namespace {

const DrumModel& model() {
    static const DrumModel learnt = learnt_drums();
    return learnt;
}

template <class Signal>
std::vector<DrumStroke> heard_in(double seconds, double rate, Signal signal) {
    std::vector<double> samples(static_cast<std::size_t>(seconds * rate));
    for (std::size_t n = 0; n < samples.size(); ++n)
        samples[n] = signal(static_cast<double>(n) / rate);
    return transcribe(samples, rate, model()).strokes;
}

std::vector<double> times_of(const std::vector<DrumStroke>& strokes, DrumClass drum) {
    std::vector<double> times;
    for (const auto& s : strokes) {
        if (s.drum == drum) times.push_back(s.time);
    }
    return times;
}

std::vector<double> times_of(const std::vector<practice::HeardStroke>& strokes, DrumClass drum) {
    std::vector<double> times;
    for (const auto& s : strokes) {
        if (s.drum == drum) times.push_back(s.time);
    }
    return times;
}

/// Seeds that learning does not use.
std::vector<practice::PieceOfMusic> unheard(std::size_t count, bool alone) {
    std::vector<practice::PieceOfMusic> pieces;
    for (std::uint64_t seed = 1; pieces.size() < count; ++seed) {
        auto piece = practice::piece_of_music(seed, 8.0);
        if (piece.alone == alone) pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// F-measure of a drum over pieces, at 50 ms.
double f_measure(const std::vector<practice::PieceOfMusic>& pieces, DrumClass drum) {
    std::size_t right = 0, all = 0;
    for (const auto& piece : pieces) {
        const auto expected = times_of(piece.strokes, drum);
        const auto found = times_of(transcribe(piece.signal, piece.rate, model()).strokes, drum);
        right += match(expected, found, 0.025).pairs.size();
        all += expected.size() + found.size();
    }
    return 2.0 * static_cast<double>(right) / static_cast<double>(all);
}

}  // namespace

TEST_CASE("drums that it never heard, alone and with others playing, are told apart") {
    const auto alone = unheard(6, true);
    const auto mixed = unheard(6, false);
    CHECK(f_measure(alone, DrumClass::kick) > 0.85);
    CHECK(f_measure(alone, DrumClass::snare) > 0.55);
    CHECK(f_measure(mixed, DrumClass::kick) > 0.7);
    CHECK(f_measure(mixed, DrumClass::snare) > 0.45);
}

TEST_CASE("how loud a recording is does not matter, nor what is silent before it") {
    const auto piece = unheard(1, true).front();
    const auto strokes = transcribe(piece.signal, piece.rate, model()).strokes;
    REQUIRE(strokes.size() > 10);

    std::vector<double> soft = piece.signal;
    for (double& x : soft) x *= 0.02;
    const auto of_soft = transcribe(soft, piece.rate, model()).strokes;
    CHECK(std::abs(static_cast<double>(of_soft.size()) / static_cast<double>(strokes.size()) -
                   1.0) < 0.1);

    const double rest = 220.0 * 100.0 / piece.rate;  // whole frames, rounded as the hop is
    std::vector<double> later(static_cast<std::size_t>(std::lround(rest * piece.rate)) + 100, 0.0);
    later.insert(later.end(), piece.signal.begin(), piece.signal.end());
    const auto of_later = transcribe(later, piece.rate, model()).strokes;
    const double shift = static_cast<double>(later.size() - piece.signal.size()) / piece.rate;
    const auto found = times_of(of_later, DrumClass::kick);
    const auto expected = times_of(strokes, DrumClass::kick);
    std::size_t same = 0;
    for (const double t : expected) {
        for (const double f : found) same += std::abs(f - shift - t) < 0.006 ? 1 : 0;
    }
    CHECK(static_cast<double>(same) > 0.85 * static_cast<double>(expected.size()));
}

TEST_CASE("velocities follow the strokes: the softer of two kicks has the lower one") {
    // With a beater: a bare sine with nothing else around might as well be a bass.
    practice::Dice dice(5);
    const auto kick = [&](double t, double at, double amplitude) {
        if (t < at) return 0.0;
        const double age = t - at;
        const double bend = 60.0 * age + 3.0 * (1.0 - std::exp(-age / 0.02));
        const double beater = 0.3 * std::exp(-age / 0.004) * dice.uniform(-1.0, 1.0);
        return amplitude *
               (beater + std::exp(-age / 0.06) * std::sin(2.0 * std::numbers::pi * bend));
    };
    const auto strokes = heard_in(4.0, 44100.0, [&](double t) {
        double sum = 0.0;
        for (int k = 0; k < 8; ++k) sum += kick(t, 0.2 + 0.45 * k, k % 2 == 0 ? 0.8 : 0.25);
        return sum;
    });
    double loud = 0.0, soft = 0.0;
    for (const auto& s : strokes) {
        if (s.drum != DrumClass::kick) continue;
        const auto k = static_cast<int>(std::lround((s.time - 0.2) / 0.45));
        (k % 2 == 0 ? loud : soft) += s.velocity;
    }
    REQUIRE(soft > 0.0);
    CHECK(loud > 1.2 * soft);
}

TEST_CASE("what holds no drums is given next to none") {
    CHECK(heard_in(3.0, 44100.0, [](double) { return 0.0; }).empty());
    CHECK(heard_in(4.0, 44100.0, [](double t) {
              return 0.5 * std::sin(2.0 * std::numbers::pi * (50.0 * t + 900.0 * t * t));
          }).size() <= 8);
    practice::Dice dice(4);
    CHECK(heard_in(4.0, 44100.0, [&](double) { return 0.2 * dice.uniform(-1.0, 1.0); }).size() <=
          8);
}

TEST_CASE("who speaks is given next to no drums, at any voice and pace") {
    std::size_t strokes = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        practice::Dice dice(seed);
        strokes +=
            transcribe(practice::speech(8 * 44100, 44100.0, dice), 44100.0, model()).strokes.size();
    }
    CHECK(strokes <= 16);  // of hundreds of hisses and stops
}

TEST_CASE("how a recording is cut into pieces does not matter, nor what it stands off zero by") {
    const auto piece = unheard(1, true).front();
    const auto whole = transcribe(piece.signal, piece.rate, model()).strokes;
    const Playback in_pieces = [&](const auto& take) {
        for (std::size_t n = 0; n < piece.signal.size(); n += 999)
            take(std::span(piece.signal)
                     .subspan(n, std::min<std::size_t>(999, piece.signal.size() - n)));
    };
    const auto cut = transcribe(in_pieces, piece.rate, model()).strokes;
    REQUIRE(cut.size() == whole.size());
    for (std::size_t i = 0; i < cut.size(); ++i) CHECK(cut[i].time == whole[i].time);

    std::vector<double> off = piece.signal;
    for (double& x : off) x += 0.4;
    const auto of_off = transcribe(off, piece.rate, model()).strokes;
    CHECK(std::abs(static_cast<double>(of_off.size()) / static_cast<double>(whole.size()) - 1.0) <
          0.1);
}

TEST_CASE("a cymbal that rings is a ride or a crash, never both") {
    Odds odds{};
    odds.fill(-1.0F);
    odds[index(DrumClass::crash)] = 2.0F;
    CHECK(verdicts(odds).size() == 0);
    odds[index(DrumClass::ride)] = 1.0F;
    REQUIRE(verdicts(odds).size() == 1);
    CHECK(verdicts(odds).begin()->drum == DrumClass::crash);
    odds[index(DrumClass::crash)] = -0.1F;
    CHECK(verdicts(odds).begin()->drum == DrumClass::ride);
}

TEST_CASE("recordings of no length or hardly any are heard through") {
    CHECK(transcribe(std::vector<double>{}, 44100.0, model()).strokes.empty());
    const std::vector<double> one = {0.7};
    CHECK(transcribe(one, 48000.0, model()).strokes.size() <= 2);
    const std::vector<double> few(500, 0.1);
    CHECK_NOTHROW(transcribe(few, 192000.0, model()));
}

TEST_CASE("a sample that is no number is refused, and so is a rate too low") {
    std::vector<double> samples(1000, 0.0);
    samples[7] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(transcribe(samples, 44100.0, model()),
                      "listening: sample 7: expected a number, got NaN or infinity");
    samples[7] = 0.0;
    CHECK_THROWS(transcribe(samples, 2000.0, model()));
}
