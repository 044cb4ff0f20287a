#include "core/listening/practice/sound.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/listening/practice/biquad.hpp"

namespace percussionist::listening::practice {

namespace {

constexpr double kLongest = 2.5;        ///< of a sound [s]
constexpr double kLossOf60 = 6.907755;  ///< ln 1000
constexpr double kTau = 2.0 * std::numbers::pi;

double length(const Recipe& recipe) {
    double longest = 0.02;
    for (const Ring& ring : recipe.rings) longest = std::max(longest, ring.t60);
    for (const Hiss& hiss : recipe.hisses) {
        longest = std::max(longest, hiss.delay + hiss.rise + hiss.hold + hiss.t60);
    }
    return std::min(longest, kLongest);
}

void add_steady(const Ring& ring, double rate, double phase, std::vector<double>& out) {
    const std::complex<double> turn =
        std::polar(std::exp(-kLossOf60 / (ring.t60 * rate)), kTau * ring.frequency / rate);
    std::complex<double> state = std::polar(ring.amplitude, phase);
    const auto end = std::min(out.size(), static_cast<std::size_t>(ring.t60 * rate));
    for (std::size_t n = 0; n < end; ++n) {
        out[n] += state.imag();
        state = {state.real() * turn.real() - state.imag() * turn.imag(),
                 state.real() * turn.imag() + state.imag() * turn.real()};
    }
}

void add_bent(const Ring& ring, double rate, double phase, std::vector<double>& out) {
    const double fade = std::exp(-kLossOf60 / (ring.t60 * rate));
    const double relax = std::exp(-1.0 / (ring.settle * rate));
    const auto end = std::min(out.size(), static_cast<std::size_t>(ring.t60 * rate));
    double amplitude = ring.amplitude;
    double bend = ring.bend - 1.0;
    for (std::size_t n = 0; n < end; ++n) {
        out[n] += amplitude * std::sin(phase);
        phase += kTau * ring.frequency * (1.0 + bend) / rate;
        amplitude *= fade;
        bend *= relax;
    }
}

void add(const Ring& ring, double rate, Dice& dice, std::vector<double>& out) {
    if (ring.frequency > 0.45 * rate) return;
    const double phase = dice.uniform(0.0, 0.5);
    if (ring.bend == 1.0) {
        add_steady(ring, rate, phase * kTau, out);
    } else {
        add_bent(ring, rate, phase, out);
    }
}

void add(const Hiss& hiss, double rate, Dice& dice, std::vector<double>& out) {
    Biquad low = Biquad::high_pass(hiss.low, rate);
    Biquad high = Biquad::low_pass(hiss.high, rate);
    const double fade = std::exp(-kLossOf60 / (hiss.t60 * rate));
    const double rise = std::max(hiss.rise * rate, 1.0);
    const double fall_from = rise + hiss.hold * rate;
    const auto start = static_cast<std::size_t>(hiss.delay * rate);
    // White noise of unit power in the whole band keeps its density, not its power.
    const double level = hiss.amplitude * std::sqrt(3.0);
    double envelope = 1.0;
    for (std::size_t n = start; n < out.size(); ++n) {
        const auto age = static_cast<double>(n - start);
        if (age > fall_from) envelope *= fade;
        if (envelope < 1e-3) break;
        const double up = std::min(age / rise, 1.0);
        out[n] += level * up * envelope * high(low(dice.uniform(-1.0, 1.0)));
    }
}

Ring varied(Ring ring, double brightness, double softest, Dice& dice) {
    const double octaves_up = std::log2(std::max(ring.frequency, 100.0) / 100.0);
    ring.amplitude *= std::exp(0.15 * dice.normal());
    ring.amplitude *= std::pow(1.0 - softest * (1.0 - brightness), octaves_up);
    ring.frequency *= 1.0 + 0.002 * dice.normal();
    ring.bend = 1.0 + (ring.bend - 1.0) * (0.3 + 0.7 * brightness);
    return ring;
}

Hiss varied(Hiss hiss, double brightness, double softest, Dice& dice) {
    hiss.amplitude *= std::exp(0.12 * dice.normal()) * (1.0 - softest * (1.0 - brightness));
    hiss.t60 *= std::exp(0.1 * dice.normal());
    hiss.high *= 1.0 - 0.6 * softest * (1.0 - brightness);
    return hiss;
}

}  // namespace

std::vector<double> sound_of(const Recipe& recipe, double brightness, double rate, Dice& dice) {
    std::vector<double> out(static_cast<std::size_t>(length(recipe) * rate), 0.0);
    for (const Ring& ring : recipe.rings) {
        add(varied(ring, brightness, recipe.softest, dice), rate, dice, out);
    }
    for (const Hiss& hiss : recipe.hisses) {
        add(varied(hiss, brightness, recipe.softest, dice), rate, dice, out);
    }
    return out;
}

}  // namespace percussionist::listening::practice
