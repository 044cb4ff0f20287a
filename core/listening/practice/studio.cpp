#include "core/listening/practice/studio.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/listening/practice/biquad.hpp"

namespace percussionist::listening::practice {

void add_room(std::vector<double>& signal, double rate, Dice& dice) {
    constexpr std::size_t kLines = 8;
    const double t60 = dice.log_uniform(0.1, 1.5);
    const double wet = std::pow(10.0, dice.uniform(-30.0, -2.0) / 20.0);
    const double dull = dice.uniform(0.1, 0.7);
    const double scale = dice.uniform(0.3, 1.0);
    std::array<std::vector<double>, kLines> lines;
    std::array<double, kLines> gain{}, state{};
    std::array<std::size_t, kLines> at{};
    for (std::size_t l = 0; l < kLines; ++l) {
        const double delay = scale * dice.uniform(0.011, 0.057);
        lines[l].assign(std::max<std::size_t>(static_cast<std::size_t>(delay * rate), 2), 0.0);
        gain[l] = std::pow(10.0, -3.0 * delay / t60);
    }
    for (double& x : signal) {
        std::array<double, kLines> out{};
        double sum = 0.0, heard = 0.0;
        for (std::size_t l = 0; l < kLines; ++l) {
            state[l] += (1.0 - dull) * (lines[l][at[l]] - state[l]);
            out[l] = gain[l] * state[l];
            sum += out[l];
            heard += l % 2 == 0 ? out[l] : -out[l];
        }
        for (std::size_t l = 0; l < kLines; ++l) {  // the Householder reflection keeps all energy
            lines[l][at[l]] = x + out[l] - 0.25 * sum;
            if (++at[l] == lines[l].size()) at[l] = 0;
        }
        x += wet * heard;
    }
}

void equalise(std::vector<double>& signal, double rate, double most_db, Dice& dice) {
    for (int band = 0; band < 4; ++band) {
        Biquad::bell(dice.log_uniform(60.0, 14000.0), rate, dice.log_uniform(0.4, 2.0),
                     dice.uniform(-most_db, most_db))(signal);
    }
    if (dice.chance(0.3)) Biquad::high_pass(dice.log_uniform(25.0, 70.0), rate)(signal);
}

void cut_top(std::vector<double>& signal, double rate, Dice& dice) {
    // Butterworth's quality factors for order 8, twice: as steep as a codec.
    constexpr std::array<double, 4> kButterworth = {0.5098, 0.6013, 0.9000, 2.5629};
    const double hz = dice.log_uniform(8000.0, 18000.0);
    for (int turn = 0; turn < 2; ++turn) {
        for (const double q : kButterworth) Biquad::low_pass(hz, rate, q)(signal);
    }
}

void normalise(std::vector<double>& signal) {
    double sum = 1e-12;
    for (const double v : signal) sum += v * v;
    const double gain = 1.0 / std::sqrt(sum / static_cast<double>(signal.size()));
    for (double& v : signal) v *= gain;
}

void compress(std::vector<double>& signal, double rate, Dice& dice) {
    normalise(signal);
    const double threshold = dice.log_uniform(0.5, 5.0);
    const double strength = 1.0 - 1.0 / dice.uniform(1.0, 6.0);
    const double attack = std::exp(-1.0 / (dice.log_uniform(0.001, 0.03) * rate));
    const double release = std::exp(-1.0 / (dice.log_uniform(0.04, 0.4) * rate));
    const double tape = dice.log_uniform(0.03, 0.4);
    constexpr std::size_t kStep = 16;  // samples for which the gain holds
    double level = 0.0, gain = 1.0;
    for (std::size_t n = 0; n < signal.size(); ++n) {
        const double now = std::abs(signal[n]);
        level = now + (now > level ? attack : release) * (level - now);
        if (n % kStep == 0) gain = level > threshold ? std::pow(threshold / level, strength) : 1.0;
        signal[n] = std::tanh(tape * gain * signal[n]) / tape;
    }
}

}  // namespace percussionist::listening::practice
