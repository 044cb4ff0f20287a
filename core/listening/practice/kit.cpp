#include "core/listening/practice/kit.hpp"

#include <algorithm>
#include <cmath>

#include "core/listening/practice/recipes.hpp"

namespace percussionist::listening::practice {

namespace {

/// The root mean square of the loudest 20 ms.
double loudness(const std::vector<double>& sound, double rate) {
    const auto span = static_cast<std::size_t>(0.02 * rate);
    double sum = 0.0, loudest = 1e-12;
    for (std::size_t n = 0; n < sound.size(); ++n) {
        sum += sound[n] * sound[n];
        if (n >= span) sum -= sound[n - span] * sound[n - span];
        loudest = std::max(loudest, sum);
    }
    return std::sqrt(loudest / static_cast<double>(span));
}

}  // namespace

DrumClass class_of(Piece piece) {
    switch (piece) {
        case Piece::kick:
            return DrumClass::kick;
        case Piece::snare:
            return DrumClass::snare;
        case Piece::closed_hat:
        case Piece::pedal_hat:
            return DrumClass::closed_hat;
        case Piece::open_hat:
            return DrumClass::open_hat;
        case Piece::ride:
        case Piece::bell:
            return DrumClass::ride;
        case Piece::crash:
        case Piece::second_crash:
            return DrumClass::crash;
        case Piece::high_tom:
        case Piece::middle_tom:
        case Piece::low_tom:
            return DrumClass::tom;
        default:
            return DrumClass::other;
    }
}

Kit::Kit(double rate, Dice& dice) : rate_(rate) {
    const auto set = [&](Piece piece, Recipe recipe, double low_db, double high_db) {
        const double norm = loudness(sound_of(recipe, 1.0, rate, dice), rate);
        parts_[static_cast<std::size_t>(piece)] = {std::move(recipe),
                                                   db(dice.uniform(low_db, high_db)) / norm};
    };
    set(Piece::kick, kick(dice), -3.0, 3.0);
    set(Piece::snare, snare(dice), -7.0, 3.0);
    set(Piece::side_stick, side_stick(dice), -14.0, -4.0);
    const HatMaker hat(dice);
    const double hats = dice.uniform(-26.0, -8.0);
    set(Piece::closed_hat, hat(dice.log_uniform(0.03, 0.2), dice.uniform(0.0, 0.002), dice),
        hats - 1.0, hats + 1.0);
    set(Piece::pedal_hat, hat(dice.log_uniform(0.03, 0.12), dice.uniform(0.001, 0.006), dice),
        hats - 6.0, hats);
    set(Piece::open_hat, hat(dice.log_uniform(0.3, 1.5), dice.uniform(0.0, 0.003), dice),
        hats - 1.0, hats + 4.0);
    const double rides = dice.uniform(-24.0, -9.0);
    set(Piece::ride, ride(dice, false), rides - 1.0, rides + 1.0);
    set(Piece::bell, ride(dice, true), rides, rides + 4.0);
    set(Piece::crash, crash(dice), -16.0, -3.0);
    set(Piece::second_crash, crash(dice), -18.0, -5.0);
    const double lowest = dice.log_uniform(58.0, 120.0);
    const double step = dice.uniform(1.2, 1.5);
    const double t60 = dice.log_uniform(0.2, 1.6);
    const double bend = dice.uniform(1.0, 1.3);
    const double slope = dice.uniform(1.0, 5.0);
    const double stick = dice.uniform(-24.0, -4.0);
    set(Piece::low_tom, tom(lowest, t60, bend, slope, stick, dice), -6.0, 1.0);
    set(Piece::middle_tom, tom(lowest * step, 0.8 * t60, bend, slope, stick, dice), -6.0, 1.0);
    set(Piece::high_tom, tom(lowest * step * step, 0.6 * t60, bend, slope, stick, dice), -6.0, 1.0);
    set(Piece::hand_percussion, by_hand(dice), -16.0, -4.0);
    set(Piece::shaken_percussion, shaken(dice), -28.0, -12.0);
}

std::vector<double> Kit::stroke(Piece piece, double velocity, Dice& dice) const {
    const Part& part = parts_[static_cast<std::size_t>(piece)];
    std::vector<double> sound = sound_of(part.recipe, velocity, rate_, dice);
    const double gain = part.level * db(-30.0 * (1.0 - velocity));
    for (double& x : sound) x *= gain;
    return sound;
}

}  // namespace percussionist::listening::practice