#include "core/listening/practice/band.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/listening/practice/biquad.hpp"
#include "core/listening/practice/recipes.hpp"
#include "core/listening/practice/studio.hpp"
#include "core/listening/practice/tone.hpp"

namespace percussionist::listening::practice {

namespace {

double hertz(double key) {
    return 440.0 * std::pow(2.0, (key - 69.0) / 12.0);
}

class Band {
  public:
    Band(const Groove& groove, std::size_t samples, double rate, Dice& dice)
        : groove_(groove),
          rate_(rate),
          dice_(dice),
          duration_(static_cast<double>(samples) / rate),
          sum_(samples, 0.0) {
        double root = dice_.uniform(28.0, 40.0);
        const bool minor = dice_.chance(0.5);
        for (double& degree : roots_) {
            constexpr std::array<double, 5> kSteps = {0.0, 5.0, 7.0, -4.0, 2.0};
            degree = root + kSteps[dice_.whole(5)];
        }
        third_ = minor ? 3.0 : 4.0;
    }

    std::vector<double> play() {
        if (dice_.chance(0.85)) add_part(bass(), dice_.uniform(-4.0, 6.0));
        if (dice_.chance(0.7)) add_part(strummed(), dice_.uniform(-8.0, 3.0));
        if (dice_.chance(0.4)) add_part(sustained(), dice_.uniform(-12.0, 0.0));
        if (dice_.chance(0.35)) add_part(distorted(), dice_.uniform(-6.0, 3.0));
        if (dice_.chance(0.55)) add_part(voice(), dice_.uniform(-6.0, 4.0));
        if (dice_.chance(0.3)) add_part(melody(), dice_.uniform(-8.0, 2.0));
        return sum_;
    }

  private:
    void add_part(std::vector<double> part, double level_db) {
        normalise(part);
        const double gain = db(level_db);
        for (std::size_t n = 0; n < sum_.size(); ++n) sum_[n] += gain * part[n];
    }
    [[nodiscard]] std::vector<double> silence() const {
        return std::vector<double>(sum_.size(), 0.0);
    }
    [[nodiscard]] double bar() const { return groove_.beat * groove_.beats; }
    [[nodiscard]] double root_at(double time) const {
        return roots_[static_cast<std::size_t>(time / bar()) % roots_.size()];
    }

    std::vector<double> bass() {
        std::vector<double> part = silence();
        const double bright = dice_.log_uniform(300.0, 5000.0);
        const auto table = wave(60.0, dice_.uniform(4.0, 14.0), bright, dice_);
        const Shape shape{.attack = dice_.uniform(0.002, 0.02),
                          .t60 = dice_.log_uniform(0.5, 5.0),
                          .release = 0.06,
                          .pluck_db = dice_.uniform(-40.0, -12.0)};
        const bool with_kick = dice_.chance(0.25);
        const double step = groove_.beat * (dice_.chance(0.6) ? 0.5 : 1.0);
        const double busy = dice_.uniform(0.4, 1.0);
        const auto note = [&](double time, double length) {
            const double key =
                root_at(time) + (dice_.chance(0.25) ? (dice_.chance(0.5) ? 7.0 : 12.0) : 0.0);
            add({time + 0.008 * dice_.normal(), length, hertz(key), dice_.uniform(0.7, 1.0)}, shape,
                table, rate_, dice_, part);
        };
        if (with_kick) {
            for (const Stroke& s : groove_.strokes) {
                if (s.piece == Piece::kick) note(s.time, groove_.beat * 0.45);
            }
        } else {
            for (double t = start(); t < duration_; t += step) {
                if (dice_.chance(busy)) note(t, step * dice_.uniform(0.5, 0.98));
            }
        }
        return part;
    }

    [[nodiscard]] double start() const {
        return groove_.strokes.empty() ? 0.0 : groove_.strokes.front().time;
    }

    std::vector<double> strummed() {
        std::vector<double> part = silence();
        const bool struck = dice_.chance(0.5);
        const double step = groove_.beat * (dice_.chance(0.5) ? 0.5 : 1.0);
        const double offbeat = dice_.chance(0.3) ? 0.5 * step : 0.0;
        const double busy = dice_.uniform(0.3, 0.95);
        const auto table =
            wave(220.0, dice_.uniform(4.0, 12.0), dice_.log_uniform(2500.0, 12000.0), dice_);
        const Shape shape{.attack = dice_.uniform(0.001, 0.012),
                          .t60 = dice_.log_uniform(0.4, 4.0),
                          .release = 0.08,
                          .pluck_db = dice_.uniform(-40.0, -4.0)};
        for (double t = start() + offbeat; t < duration_; t += step) {
            if (!dice_.chance(busy)) continue;
            const double length = step * dice_.uniform(0.2, 0.95);
            double late = 0.006 * dice_.normal();
            for (const double interval : {12.0, 12.0 + third_, 19.0, 24.0}) {
                add({t + late, length, hertz(root_at(t) + 12.0 + interval),
                     dice_.uniform(0.5, 1.0)},
                    shape, table, rate_, dice_, part);
                if (!struck) late += dice_.uniform(0.0, 0.01);
            }
        }
        return part;
    }

    std::vector<double> sustained() {
        std::vector<double> part = silence();
        const auto table =
            wave(220.0, dice_.uniform(3.0, 12.0), dice_.log_uniform(2000.0, 9000.0), dice_);
        const Shape shape{.attack = dice_.log_uniform(0.01, 0.4),
                          .t60 = 20.0,
                          .release = 0.2,
                          .vibrato = dice_.uniform(0.0, 0.006)};
        for (double t = start(); t < duration_; t += bar()) {
            for (const double interval : {12.0, 12.0 + third_, 19.0}) {
                add({t, bar() * 0.95,
                     hertz(root_at(t) + 12.0 + interval) * (1.0 + 0.002 * dice_.normal()), 0.7},
                    shape, table, rate_, dice_, part);
            }
        }
        return part;
    }

    std::vector<double> distorted() {
        std::vector<double> part = silence();
        const auto table = wave(110.0, 6.0, 8000.0, dice_);
        const double step = groove_.beat * (dice_.chance(0.5) ? 0.5 : 2.0);
        const Shape shape{.attack = 0.003,
                          .t60 = dice_.log_uniform(1.0, 8.0),
                          .release = 0.03,
                          .pluck_db = dice_.uniform(-40.0, -6.0)};
        const bool palm = dice_.chance(0.4);
        for (double t = start(); t < duration_; t += step) {
            if (!dice_.chance(0.85)) continue;
            for (const double interval : {12.0, 19.0, 24.0}) {
                add({t + 0.005 * dice_.normal(), step * (palm ? 0.3 : 0.95),
                     hertz(root_at(t) + interval), 0.8},
                    shape, table, rate_, dice_, part);
            }
        }
        normalise(part);
        const double drive = dice_.log_uniform(1.0, 15.0);
        for (double& x : part) x = std::tanh(drive * x);
        Biquad speaker = Biquad::low_pass(dice_.uniform(3500.0, 7000.0), rate_);
        Biquad open = Biquad::high_pass(90.0, rate_);
        speaker(part);
        open(part);
        return part;
    }

    std::vector<double> voice() {
        std::vector<double> part = silence();
        const auto table = wave(200.0, dice_.uniform(2.0, 6.0), 9000.0, dice_);
        const double register_key = dice_.uniform(48.0, 70.0);
        const double hiss_db = dice_.uniform(-26.0, -6.0);
        double t = start() + dice_.uniform(0.0, 2.0);
        while (t < duration_) {
            const double length = dice_.log_uniform(0.1, 0.8);
            if (dice_.chance(0.25)) {
                t += dice_.uniform(0.3, 2.0);
                continue;
            }
            std::vector<double> syllable(static_cast<std::size_t>((length + 0.3) * rate_), 0.0);
            const Shape shape{.attack = dice_.log_uniform(0.015, 0.08),
                              .t60 = 10.0,
                              .release = 0.06,
                              .vibrato = dice_.uniform(0.0, 0.015),
                              .glide = dice_.chance(0.4) ? 0.06 : 0.0};
            add({0.0, length, hertz(register_key + std::floor(dice_.uniform(0.0, 13.0))), 1.0},
                shape, table, rate_, dice_, syllable);
            vowel(syllable);
            if (dice_.chance(0.35)) consonant(db(hiss_db), syllable);
            const auto at = static_cast<std::size_t>(t * rate_);
            for (std::size_t n = 0; n < syllable.size() && at + n < part.size(); ++n)
                part[at + n] += syllable[n];
            t += length + (dice_.chance(0.5) ? 0.02 : dice_.uniform(0.02, 0.3));
        }
        return part;
    }

    void vowel(std::vector<double>& x) {
        std::vector<double> out(x.size(), 0.0);
        for (const double formant : {dice_.uniform(300.0, 850.0), dice_.uniform(900.0, 2400.0),
                                     dice_.uniform(2500.0, 3600.0)}) {
            Biquad resonance = Biquad::band_pass(formant, rate_, dice_.uniform(3.0, 8.0));
            for (std::size_t n = 0; n < x.size(); ++n) out[n] += resonance(x[n]);
        }
        x = std::move(out);
    }

    /// s, sh, f, t: the voice's own cymbals and sticks.
    void consonant(double level, std::vector<double>& x) {
        const bool stop = dice_.chance(0.35);
        Biquad colour = Biquad::high_pass(dice_.log_uniform(2000.0, 6000.0), rate_);
        const double rise = stop ? 0.001 : dice_.uniform(0.015, 0.06);
        const double length = stop ? 0.03 : dice_.uniform(0.05, 0.16);
        const auto end = std::min(x.size(), static_cast<std::size_t>((length + 0.04) * rate_));
        for (std::size_t n = 0; n < end; ++n) {
            const double t = static_cast<double>(n) / rate_;
            const double envelope =
                std::min({t / rise, 1.0, std::max(0.0, (length + 0.04 - t) / 0.04)});
            x[n] += level * envelope * colour(dice_.uniform(-1.0, 1.0));
        }
    }

    std::vector<double> melody() {
        std::vector<double> part = silence();
        const auto table =
            wave(440.0, dice_.uniform(2.0, 10.0), dice_.log_uniform(4000.0, 14000.0), dice_);
        const Shape shape{.attack = dice_.log_uniform(0.003, 0.06),
                          .t60 = dice_.log_uniform(0.5, 8.0),
                          .release = 0.05,
                          .vibrato = dice_.uniform(0.0, 0.01),
                          .glide = dice_.uniform(0.0, 0.04),
                          .pluck_db = dice_.uniform(-40.0, -10.0)};
        const double step = groove_.beat * 0.5;
        for (double t = start(); t < duration_; t += step) {
            if (!dice_.chance(0.5)) continue;
            constexpr std::array<double, 5> kScale = {0.0, 3.0, 5.0, 7.0, 10.0};
            const double key =
                roots_[0] + 36.0 + kScale[dice_.whole(5)] + (dice_.chance(0.3) ? 12.0 : 0.0);
            add({t + 0.01 * dice_.normal(), step * dice_.uniform(0.4, 2.0), hertz(key),
                 dice_.uniform(0.5, 1.0)},
                shape, table, rate_, dice_, part);
        }
        return part;
    }

    const Groove& groove_;
    double rate_;
    Dice& dice_;
    double duration_;
    std::vector<double> sum_;
    std::array<double, 4> roots_{};
    double third_ = 4.0;
};

}  // namespace

std::vector<double> accompaniment(const Groove& groove, std::size_t samples, double rate,
                                  Dice& dice) {
    return Band(groove, samples, rate, dice).play();
}

}  // namespace percussionist::listening::practice
