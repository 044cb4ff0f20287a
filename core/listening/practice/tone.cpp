#include "core/listening/practice/tone.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/listening/practice/biquad.hpp"
#include "core/listening/practice/recipes.hpp"

namespace percussionist::listening::practice {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr std::size_t kTable = 2048;

}  // namespace

std::vector<double> wave(double frequency, double slope_db, double limit, Dice& dice) {
    std::vector<double> table(kTable, 0.0);
    const double evens = dice.chance(0.3) ? 0.2 : 1.0;
    for (int h = 1; h <= 60 && h * frequency < limit; ++h) {
        const double amplitude =
            db(-slope_db * std::log2(static_cast<double>(h)) + 3.0 * dice.normal()) *
            (h % 2 == 0 ? evens : 1.0);
        const double phase = dice.uniform();
        for (std::size_t n = 0; n < kTable; ++n) {
            const double turn = static_cast<double>(h) * static_cast<double>(n) / kTable + phase;
            table[n] += amplitude * std::sin(kTau * (turn - std::floor(turn)));
        }
    }
    return table;
}

void add(const Tone& tone, const Shape& shape, const std::vector<double>& table, double rate,
         Dice& dice, std::vector<double>& out) {
    const auto from = static_cast<std::size_t>(std::max(tone.time, 0.0) * rate);
    const auto held = static_cast<std::size_t>(tone.duration * rate);
    const auto all = held + static_cast<std::size_t>(shape.release * rate);
    const double fade = std::exp(-6.9078 / (shape.t60 * rate));
    const double fall = std::exp(-6.9078 / (shape.release * rate));
    const double settle = std::exp(-1.0 / (0.03 * rate));
    const double vibrato_rate = dice.uniform(4.5, 7.0) * kTau / rate;
    double phase = dice.uniform() * kTable, envelope = tone.amplitude, glide = shape.glide;
    double vibrato = 0.0;
    for (std::size_t n = 0; n < all && from + n < out.size(); ++n) {
        const double up = std::min(static_cast<double>(n) / (shape.attack * rate), 1.0);
        out[from + n] += envelope * up * table[static_cast<std::size_t>(phase) % kTable];
        if (n % 32 == 0 && shape.vibrato > 0.0) {
            vibrato = shape.vibrato * std::sin(vibrato_rate * static_cast<double>(n));
        }
        phase += kTable * tone.frequency * (1.0 - glide + vibrato) / rate;
        if (phase >= kTable) phase -= kTable;
        envelope *= n < held ? fade : fall;
        glide *= settle;
    }
    if (shape.pluck_db > -39.0) {
        const double level = db(shape.pluck_db) * tone.amplitude * 3.0;
        Biquad colour = Biquad::band_pass(dice.log_uniform(500.0, 6000.0), rate, 0.5);
        const double quick = std::exp(-6.9078 / (dice.log_uniform(0.008, 0.04) * rate));
        double left = level;
        for (std::size_t n = from; n < out.size() && left > 1e-3 * level; ++n, left *= quick) {
            out[n] += left * colour(dice.uniform(-1.0, 1.0));
        }
    }
}

}  // namespace percussionist::listening::practice
