#include "core/listening/practice/speech.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/listening/practice/biquad.hpp"
#include "core/listening/practice/recipes.hpp"

namespace percussionist::listening::practice {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr std::size_t kFormants = 4;
constexpr std::size_t kStep = 64;  ///< samples for which a resonance holds
using Formants = std::array<double, kFormants>;

/// A resonance that can be moved while it sounds.
class Resonance {
  public:
    void tune(double hz, double width, double rate) {
        const double radius = std::exp(-0.5 * kTau * width / rate);
        first_ = 2.0 * radius * std::cos(kTau * std::min(hz, 0.45 * rate) / rate);
        second_ = -radius * radius;
        gain_ = 1.0 - radius;
    }
    double operator()(double x) {
        const double y = gain_ * x + first_ * before_ + second_ * earlier_;
        earlier_ = before_;
        before_ = y;
        return y;
    }

  private:
    double first_ = 0.0, second_ = 0.0, gain_ = 0.0;
    double before_ = 0.0, earlier_ = 0.0;
};

class Speaker {
  public:
    Speaker(std::size_t samples, double rate, Dice& dice)
        : rate_(rate),
          dice_(dice),
          out_(samples, 0.0),
          whispers_(dice.chance(0.1)),
          pitch_(dice.log_uniform(75.0, 300.0)),
          size_(dice.uniform(0.85, 1.25)),
          pace_(dice.log_uniform(0.6, 1.6)),
          hiss_(db(dice.uniform(-24.0, 0.0))),
          burst_(db(dice.uniform(-20.0, 4.0))),
          slope_(dice.uniform(0.6, 0.97)) {}

    std::vector<double> speak() {
        at_ = seconds(dice_.uniform(0.0, 0.6));
        while (at_ < out_.size()) {
            phrase();
            at_ += seconds(dice_.log_uniform(0.15, 1.2));
        }
        return std::move(out_);
    }

  private:
    [[nodiscard]] std::size_t seconds(double time) const {
        return static_cast<std::size_t>(time * rate_);
    }
    void put(std::size_t at, double value) {
        if (at < out_.size()) out_[at] += value;
    }

    void phrase() {
        const std::size_t syllables = 2 + dice_.whole(12);
        fall_ = 1.15;
        for (std::size_t s = 0; s < syllables && at_ < out_.size(); ++s) {
            consonant();
            if (dice_.chance(0.2)) consonant();
            vowel();
            if (dice_.chance(0.35)) consonant();
            fall_ *= dice_.uniform(0.93, 1.02);
        }
    }

    void consonant() {
        const double kind = dice_.uniform();
        if (kind < 0.3) {
            stop();
        } else if (kind < 0.6) {
            hiss();
        } else if (kind < 0.8) {  // m, n, l
            voiced(pace_ * dice_.uniform(0.04, 0.09), {250.0, 1200.0, 2300.0, 3300.0},
                   db(dice_.uniform(-18.0, -8.0)));
        }
    }

    /// p t k, b d g: closed, then a burst, then breath.
    void stop() {
        at_ += seconds(pace_ * dice_.uniform(0.02, 0.09));
        Biquad colour =
            Biquad::band_pass(dice_.log_uniform(600.0, 6000.0), rate_, dice_.log_uniform(0.4, 2.0));
        const double level = 3.0 * burst_ * db(dice_.uniform(-10.0, 0.0));
        const double fade = std::exp(-6.9 / (dice_.log_uniform(0.008, 0.04) * rate_));
        const std::size_t breath =
            dice_.chance(0.5) ? seconds(dice_.uniform(0.02, 0.07)) : seconds(0.005);
        const double breathes = db(dice_.uniform(-24.0, -8.0));
        double envelope = 1.0;
        const std::size_t size = breath + seconds(0.02);
        for (std::size_t n = 0; n < size; ++n, envelope *= fade) {
            const double air =
                n < breath ? breathes : breathes * std::exp(-0.005 * double(n - breath));
            put(at_ + n, level * (envelope + air) * colour(dice_.uniform(-1.0, 1.0)));
        }
        at_ += breath;
    }

    /// s sh f th: rising and falling in tens of milliseconds; z and v hum besides.
    void hiss() {
        const double length = pace_ * dice_.log_uniform(0.05, 0.2);
        Biquad low = Biquad::high_pass(dice_.log_uniform(1200.0, 6500.0), rate_);
        Biquad peak =
            Biquad::bell(dice_.log_uniform(2000.0, 9000.0), rate_, 2.0, dice_.uniform(0.0, 18.0));
        const double level = hiss_ * db(dice_.uniform(-12.0, 0.0));
        const double rise = std::min(dice_.log_uniform(0.008, 0.08), 0.5 * length);
        const double fall = std::min(dice_.log_uniform(0.008, 0.06), 0.5 * length);
        for (std::size_t n = 0; n < seconds(length); ++n) {
            const double t = static_cast<double>(n) / rate_;
            const double envelope = std::min({t / rise, 1.0, (length - t) / fall});
            put(at_ + n, level * envelope * peak(low(dice_.uniform(-1.0, 1.0))));
        }
        if (!whispers_ && dice_.chance(0.25)) {
            voiced(length, {250.0, 1400.0, 2500.0, 3400.0}, db(dice_.uniform(-20.0, -8.0)));
        } else {
            at_ += seconds(length * dice_.uniform(0.8, 1.0));
        }
    }

    void vowel() {
        voiced(pace_ * dice_.log_uniform(0.05, 0.3),
               {dice_.uniform(280.0, 850.0), dice_.log_uniform(750.0, 2400.0),
                dice_.uniform(2200.0, 3000.0), dice_.uniform(3200.0, 4200.0)},
               db(dice_.uniform(-8.0, 0.0)));
    }

    void voiced(double length, const Formants& towards, double level) {
        const Formants from = formants_;
        const std::size_t size = seconds(length);
        const double edge = std::min(dice_.log_uniform(0.01, 0.05), 0.5 * length) * rate_;
        const double goes = dice_.uniform(0.94, 1.06);
        for (std::size_t n = 0; n < size; ++n) {
            const double share = static_cast<double>(n) / static_cast<double>(size);
            if (n % kStep == 0) move(from, towards, std::min(2.0 * share, 1.0));
            const double edges = std::min(
                {static_cast<double>(n) / edge, 1.0, static_cast<double>(size - n) / edge});
            double x = source(pitch_ * fall_ * (1.0 + (goes - 1.0) * share));
            for (Resonance& resonance : resonances_) x = 3.0 * resonance(x);
            put(at_ + n, 6.0 * level * edges * x);
        }
        at_ += size;
    }

    void move(const Formants& from, const Formants& towards, double share) {
        for (std::size_t f = 0; f < kFormants; ++f) {
            formants_[f] = from[f] + share * (towards[f] - from[f]);
            resonances_[f].tune(size_ * formants_[f], 60.0 + 40.0 * static_cast<double>(f), rate_);
        }
    }

    /// Pulses, made duller, and breath; or breath alone.
    double source(double pitch) {
        phase_ += pitch / rate_;
        double pulse = 0.0;
        if (phase_ >= 1.0) {
            phase_ -= 1.0;
            pulse = whispers_ ? 0.0 : std::sqrt(rate_ / pitch) * (1.0 + 0.1 * dice_.normal());
        }
        dull_ = slope_ * dull_ + (1.0 - slope_) * pulse;
        return dull_ + (whispers_ ? 0.5 : 0.01) * dice_.uniform(-1.0, 1.0);
    }

    double rate_;
    Dice& dice_;
    std::vector<double> out_;
    bool whispers_;
    double pitch_;  ///< [Hz]
    double size_;   ///< of all resonances' frequencies: a child's or a man's mouth
    double pace_;
    double hiss_, burst_;
    double slope_;  ///< how dull the pulses are
    double fall_ = 1.0, phase_ = 0.0, dull_ = 0.0;
    std::size_t at_ = 0;
    Formants formants_ = {500.0, 1500.0, 2500.0, 3500.0};
    std::array<Resonance, kFormants> resonances_;
};

}  // namespace

std::vector<double> speech(std::size_t samples, double rate, Dice& dice) {
    return Speaker(samples, rate, dice).speak();
}

}  // namespace percussionist::listening::practice
