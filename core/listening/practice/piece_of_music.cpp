#include "core/listening/practice/piece_of_music.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/listening/practice/band.hpp"
#include "core/listening/practice/biquad.hpp"
#include "core/listening/practice/groove.hpp"
#include "core/listening/practice/kit.hpp"
#include "core/listening/practice/speech.hpp"
#include "core/listening/practice/studio.hpp"

namespace percussionist::listening::practice {

namespace {

constexpr double kUndrummed = 0.16;  ///< of pieces have no drums at all
constexpr double kSpoken = 0.5;      ///< of those are somebody who speaks
constexpr double kSpokenOver = 0.1;  ///< of the others are spoken over
constexpr double kNoisy = 0.06;      ///< are noise above all
constexpr double kChoke = 0.01;      ///< in which a hat that closes falls silent [s]

bool is_hat(Piece piece) {
    return piece == Piece::closed_hat || piece == Piece::pedal_hat || piece == Piece::open_hat;
}

/// A few sounds of each piece, made when first wanted: to synthesise each stroke would take long.
class Shelf {
  public:
    Shelf(const Kit& kit, Dice& dice) : kit_(kit), dice_(dice) {}

    const std::vector<double>& sound(Piece piece, double velocity, double& gain) {
        constexpr std::array<double, 3> kLayers = {0.4, 0.7, 0.95};
        const std::size_t layer = velocity < 0.5 ? 0 : velocity < 0.8 ? 1 : 2;
        gain = std::pow(10.0, 30.0 / 20.0 * (velocity - kLayers[layer]));
        auto& sound = sounds_[static_cast<std::size_t>(piece)][layer][dice_.whole(2)];
        if (sound.empty()) sound = kit_.stroke(piece, kLayers[layer], dice_);
        return sound;
    }

  private:
    const Kit& kit_;
    Dice& dice_;
    std::array<std::array<std::array<std::vector<double>, 2>, 3>, kPieces> sounds_;
};

std::vector<double> drums(const Groove& groove, std::size_t samples, double rate, Dice& dice) {
    const Kit kit(rate, dice);
    Shelf shelf(kit, dice);
    std::vector<double> out(samples, 0.0);
    for (std::size_t s = 0; s < groove.strokes.size(); ++s) {
        const Stroke& stroke = groove.strokes[s];
        std::size_t end = samples;
        if (stroke.piece == Piece::open_hat) {
            for (std::size_t later = s + 1; later < groove.strokes.size(); ++later) {
                if (is_hat(groove.strokes[later].piece)) {
                    end = static_cast<std::size_t>(groove.strokes[later].time * rate);
                    break;
                }
            }
        }
        double gain = 1.0;
        const auto& sound = shelf.sound(stroke.piece, stroke.velocity, gain);
        const auto from = static_cast<std::size_t>(stroke.time * rate);
        const double choke = std::exp(-1.0 / (kChoke * rate));
        for (std::size_t n = 0; n < sound.size() && from + n < samples && gain > 1e-4; ++n) {
            out[from + n] += gain * sound[n];
            if (from + n > end) gain *= choke;
        }
    }
    return out;
}

/// What is there when nobody plays: amplifiers, air, mains.
void add_ground(std::vector<double>& signal, double rate, Dice& dice) {
    const double hiss_db =
        dice.chance(kNoisy) ? dice.uniform(-30.0, 10.0) : dice.uniform(-90.0, -40.0);
    const double hiss = std::pow(10.0, hiss_db / 20.0);
    const double rumble = std::pow(10.0, dice.uniform(-70.0, -20.0) / 20.0);
    Biquad low = Biquad::low_pass(dice.log_uniform(60.0, 600.0), rate);
    for (double& x : signal)
        x += hiss * dice.uniform(-1.0, 1.0) + 6.0 * rumble * low(dice.uniform(-1.0, 1.0));
}

void speak_over(std::vector<double>& signal, double rate, Dice& dice) {
    std::vector<double> voice = speech(signal.size(), rate, dice);
    normalise(voice);
    normalise(signal);
    const double level = std::pow(10.0, dice.uniform(-6.0, 12.0) / 20.0);
    for (std::size_t n = 0; n < signal.size(); ++n) signal[n] += level * voice[n];
}

}  // namespace

PieceOfMusic piece_of_music(std::uint64_t seed, double duration) {
    Dice dice(seed);
    PieceOfMusic piece;
    const auto samples = static_cast<std::size_t>(duration * piece.rate);
    Groove groove = throw_groove(duration, dice);
    const bool undrummed = dice.chance(kUndrummed);
    const bool spoken = undrummed && dice.chance(kSpoken);
    if (undrummed) groove.strokes.clear();
    piece.beat = groove.beat;
    piece.beats = groove.beats;
    piece.signal = drums(groove, samples, piece.rate, dice);
    for (const Stroke& s : groove.strokes) {
        piece.strokes.push_back({s.time, class_of(s.piece), s.velocity});
    }
    if (dice.chance(0.7)) equalise(piece.signal, piece.rate, 8.0, dice);
    if (dice.chance(0.9)) add_room(piece.signal, piece.rate, dice);
    if (dice.chance(0.5)) compress(piece.signal, piece.rate, dice);
    normalise(piece.signal);
    piece.alone = dice.chance(0.35) && !undrummed;
    if (!piece.alone) {
        std::vector<double> others = spoken ? speech(samples, piece.rate, dice)
                                            : accompaniment(groove, samples, piece.rate, dice);
        if (!spoken && dice.chance(kSpokenOver)) speak_over(others, piece.rate, dice);
        if (dice.chance(0.5)) add_room(others, piece.rate, dice);
        normalise(others);
        const double level = std::pow(10.0, dice.uniform(-14.0, 6.0) / 20.0);
        for (std::size_t n = 0; n < samples; ++n) piece.signal[n] += level * others[n];
        if (dice.chance(0.5)) compress(piece.signal, piece.rate, dice);
    }
    equalise(piece.signal, piece.rate, 6.0, dice);
    add_ground(piece.signal, piece.rate, dice);
    if (dice.chance(0.6)) cut_top(piece.signal, piece.rate, dice);
    normalise(piece.signal);
    for (double& x : piece.signal) x *= 0.1;
    return piece;
}

}  // namespace percussionist::listening::practice
