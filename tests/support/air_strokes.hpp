// Strokes in the air, by a person and against nothing: families of movements, each with random
// parameters, whose turning points are known. Written apart from the stick that plays a plane
// (core/motion/synthetic_stick.hpp), so that what is fitted to the one can be judged on the other.
//
// A movement is a height over time, made of pieces, along a direction of any tilt; besides it the
// stick turns about a wrist, loops, wanders, and the tracker adds noise, repeats and losses.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/linear/pose.hpp"
#include "core/motion/pose_gate.hpp"

namespace percussionist::test {

using linear::Vector3;
using motion::TimedPose;

/// Seconds and metres, upward.
enum class Ease { kLine, kFall, kRise, kCosine, kMinimumJerk, kArch, kContact };

struct Piece {
    double duration = 0.0;
    double from = 0.0, to = 0.0;
    Ease ease = Ease::kLine;
    double in = 0.0, out = 0.0;  ///< rates at a contact's ends [m/s]

    double at(double t) const {
        const double s = duration > 0 ? t / duration : 1.0;
        switch (ease) {
            case Ease::kFall:
                return from + (to - from) * s * s;
            case Ease::kRise:
                return from + (to - from) * s * (2 - s);
            case Ease::kCosine:
                return from + (to - from) * 0.5 * (1 - std::cos(M_PI * s));
            case Ease::kMinimumJerk:
                return from + (to - from) * s * s * s * (10 + s * (6 * s - 15));
            case Ease::kArch:
                return from + (to - from) * std::sin(M_PI * s);
            case Ease::kContact: {
                const double s2 = s * s, s3 = s2 * s;
                return (2 * s3 - 3 * s2 + 1) * from + (s3 - 2 * s2 + s) * duration * in +
                       (3 * s2 - 2 * s3) * to + (s3 - s2) * duration * out;
            }
            default:
                return from + (to - from) * s;
        }
    }
};

/// Pieces after one another.
class Height {
  public:
    void add(const Piece& piece) {
        starts_.push_back(end_);
        pieces_.push_back(piece);
        end_ += piece.duration;
    }
    void go(double duration, double to, Ease ease) { add({duration, last(), to, ease}); }
    void hold(double duration) { go(duration, last(), Ease::kLine); }
    double last() const {
        return pieces_.empty() ? 0.0 : pieces_.back().at(pieces_.back().duration);
    }
    double end() const { return end_; }
    double at(double time) const {
        if (pieces_.empty() || time <= 0) {
            return pieces_.empty() ? 0.0 : pieces_.front().from;
        }
        const auto next = std::upper_bound(starts_.begin(), starts_.end(), time);
        const auto i = static_cast<std::size_t>(next - starts_.begin()) - 1;
        return pieces_[i].at(std::min(time - starts_[i], pieces_[i].duration));
    }

  private:
    std::vector<Piece> pieces_;
    std::vector<double> starts_;
    double end_ = 0.0;
};

struct AirSettings {
    unsigned seed = 1;
    double rate = 120.0;                  ///< [1/s]
    double noise = 0.0;                   ///< per axis [m]; 0: from 0.1 to 0.5 mm, each run another
    double repeats = 0.01, lost = 0.005;  ///< parts of all records
};

struct AirTrial {
    std::vector<double> turns;     ///< the turning points' times [s]
    std::vector<double> peaks;     ///< of the greatest deceleration before each [s]
    std::vector<TimedPose> poses;  ///< of the tip, in the world
    double duration = 0.0;
};

class AirStrokes {
  public:
    explicit AirStrokes(const AirSettings& settings)
        : settings_(settings), random_(settings.seed) {}

    static std::vector<std::string> families() {
        return {"bounce", "soft", "round",  "swing",     "jerk",    "dead",   "roll",
                "arc",    "loop", "skewed", "wandering", "accents", "lifted", "stops"};
    }

    AirTrial make(const std::string& family) {
        if (family == "bounce" || family == "accents") {
            bounces(0.5, 4.0, family == "accents");
        } else if (family == "soft") {
            bounces(0.25, 0.8, false);
        } else if (family == "round" || family == "loop") {
            rounds();
        } else if (family == "swing" || family == "skewed") {
            swings(family == "skewed" ? uniform(0.1, 0.6) : 0.0);
        } else if (family == "jerk") {
            jerks();
        } else if (family == "dead") {
            dead();
        } else if (family == "roll") {
            rolls();
        } else if (family == "lifted") {
            lifted();
        } else if (family == "stops") {
            stops();
        } else {
            uniform(0, 1) < 0.5 ? bounces(0.5, 3.0, false) : rounds();
        }
        return seen(family);
    }

  private:
    double uniform(double low, double high) {
        return std::uniform_real_distribution<>(low, high)(random_);
    }
    double geometric(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
    Vector3 gauss(double scale) {
        std::normal_distribution<> normal;
        return {scale * normal(random_), scale * normal(random_), scale * normal(random_)};
    }
    void turn() { turns_.push_back(height_.end()); }
    /// Between strokes: mostly none, now and then a while.
    double pause(double part = 0.3) { return uniform(0, 1) < part ? uniform(0.05, 0.5) : 0.0; }

    /// Struck with v, it goes out with e v, and up to a height.
    void bounce(double v, double e, double contact, double up) {
        const double out = e * v;
        turns_.push_back(height_.end() + contact * 0.5);
        height_.add({contact, 0, 0, Ease::kContact, -v, out});
        height_.go(2 * up / out, up, Ease::kRise);
    }
    void bounces(double slowest, double fastest, bool accents) {
        const double contact = uniform(0.004, 0.014), e = uniform(0.3, 0.9);
        const double loud = geometric(slowest, fastest);
        height_.go(0.3, 0.05, Ease::kMinimumJerk);
        for (int i = 0; i < 45; ++i) {
            const double v = accents ? (i % 4 == 0 ? 3.0 : uniform(0.5, 1.0))
                                     : std::clamp(loud * geometric(0.6, 1.6), slowest, fastest);
            const double top = height_.last(), down = 2 * top / v;
            height_.go(down, 0.0, Ease::kFall);
            // A hand takes 80 to 250 ms up at most, so how high it goes depends on how fast.
            bounce(v, e, contact, std::clamp(0.5 * e * v * uniform(0.08, 0.25), 0.01, 0.3));
            height_.hold(pause());
        }
    }
    void rounds() {
        const double tempo = uniform(0.1, 0.25), slow_up = uniform(1.0, 2.0);
        height_.go(0.4, uniform(0.05, 0.2), Ease::kMinimumJerk);
        for (int i = 0; i < 45; ++i) {
            const double down = tempo * uniform(0.8, 1.25);
            height_.go(down, 0.0, Ease::kCosine);
            turn();
            height_.go(down * slow_up, std::min(0.2, geometric(0.5, 2.0) * down), Ease::kCosine);
            height_.hold(pause());
        }
    }
    /// h = a (1 + cos(phase + skew sin(phase))) / 2: with skew it is longer up than down.
    void swings(double skew) {
        const double f = uniform(1.5, 4.0), a = uniform(0.3, 1.0) / f * 0.3;
        for (int i = 0; i < 45; ++i) {
            const double high = i == 0 ? a : height_.last(), next = a * uniform(0.7, 1.4);
            const double period = uniform(0.93, 1.07) / f;
            half_swing(period, high, true, skew);
            turn();
            half_swing(period, next, false, skew);
        }
    }
    void half_swing(double period, double high, bool down, double skew) {
        // In many short lines; at the bottom, the phase pi, it is faster by (1 + skew) / (1 -
        // skew).
        constexpr int kSteps = 40;
        for (int k = 1; k <= kSteps; ++k) {
            const double s = static_cast<double>(k) / kSteps;
            const double phase = M_PI * (down ? s : 1 + s);
            const double h = high * 0.5 * (1 + std::cos(phase - skew * std::sin(phase)));
            height_.add({0.5 * period / kSteps, height_.end() == 0.0 ? high : height_.last(), h,
                         Ease::kLine});
        }
    }
    void jerks() {
        const double quick = uniform(0.1, 0.18), dwell = uniform(0.0, 0.05);
        height_.go(0.4, 0.1, Ease::kMinimumJerk);
        for (int i = 0; i < 40; ++i) {
            height_.go(quick * uniform(0.9, 1.15), 0.0, Ease::kMinimumJerk);
            turn();
            height_.hold(dwell);
            height_.go(uniform(0.18, 0.4), uniform(0.05, 0.16), Ease::kMinimumJerk);
            height_.hold(pause());
        }
    }
    void dead() {
        const double stop = uniform(0.008, 0.03);
        height_.go(0.4, 0.1, Ease::kMinimumJerk);
        for (int i = 0; i < 40; ++i) {
            const double v = geometric(0.6, 3.5), deep = 0.5 * v * stop;
            height_.go(2 * (height_.last() + 0.0) / v, 0.0, Ease::kFall);
            height_.go(stop, -deep, Ease::kRise);
            turn();
            height_.hold(uniform(0.02, 0.2));
            height_.go(uniform(0.2, 0.4), 0.5 * v * uniform(0.06, 0.12), Ease::kCosine);
            height_.hold(pause());
        }
    }
    void rolls() {
        for (int i = 0; i < 8; ++i) {
            const double gap = 1 / uniform(6.5, 12.0), v = geometric(0.4, 1.6);
            height_.go(0.3, 0.06, Ease::kMinimumJerk);
            height_.go(0.12 / v, 0.0, Ease::kFall);
            const int strokes = std::uniform_int_distribution<>(5, 18)(random_);
            for (int k = 0; k < strokes; ++k) {
                turns_.push_back(height_.end() + 0.002);
                height_.add({0.004, 0, 0, Ease::kContact, -v, v * 0.9});
                if (k + 1 < strokes) {
                    height_.add({gap - 0.004, 0.0, v * (gap - 0.004) / M_PI, Ease::kArch});
                }
            }
            height_.go(0.1 / v, 0.05, Ease::kRise);
            height_.hold(uniform(0.2, 0.6));
        }
    }
    /// Slowly up, a quick hand down, and as hard a turn as a hand makes.
    void lifted() {
        for (int i = 0; i < 40; ++i) {
            const double v = geometric(0.4, 3.0), high = v * uniform(0.05, 0.09);
            height_.go(uniform(0.2, 0.5), high, Ease::kMinimumJerk);
            height_.hold(pause(0.4));
            height_.go(2 * high / v, 0.0, Ease::kFall);
            const double stop = uniform(0.02, 0.045);
            height_.go(stop, -0.5 * v * stop, Ease::kRise);
            turn();
            height_.go(stop, 0.0, Ease::kFall);
            height_.go(uniform(0.03, 0.08), height_.last() + 0.02, Ease::kRise);
        }
    }
    /// Strokes with a sharp end and long still times between them.
    void stops() {
        const double e = uniform(0.1, 0.4);
        for (int i = 0; i < 25; ++i) {
            height_.hold(uniform(0.3, 1.2));
            const double v = geometric(0.5, 3.0);
            height_.go(uniform(0.15, 0.3), v * uniform(0.05, 0.1), Ease::kCosine);
            height_.go(2 * height_.last() / v, 0.0, Ease::kFall);
            bounce(v, e, uniform(0.005, 0.02), 0.5 * e * v * 0.1);
            height_.go(0.3, 0.0, Ease::kMinimumJerk);
        }
    }

    double deceleration_peak(double turn) const {
        constexpr double kStep = 2.5e-3;
        double most = -1.0, when = turn;
        for (double t = turn - 0.12; t <= turn + 0.004; t += 0.5e-3) {
            const double bend = height_.at(t - kStep) - 2 * height_.at(t) + height_.at(t + kStep);
            if (bend > most) {
                most = bend;
                when = t;
            }
        }
        return when;
    }

    AirTrial seen(const std::string& family) {
        AirTrial trial;
        trial.turns = turns_;
        for (const double turn : turns_) {
            trial.peaks.push_back(deceleration_peak(turn));
        }
        trial.duration = height_.end() + 0.3;
        const auto path = embed(family);
        const double noise = settings_.noise > 0 ? settings_.noise : geometric(1e-4, 5e-4);
        for (double time = 0.0; time < trial.duration; time += 1 / settings_.rate) {
            if (uniform(0, 1) < settings_.lost) {
                continue;
            }
            if (!trial.poses.empty() && uniform(0, 1) < settings_.repeats) {
                trial.poses.push_back({time, trial.poses.back().pose});
                continue;
            }
            trial.poses.push_back(
                {time, {path(time) + gauss(noise), linear::Quaternion::Identity()}});
        }
        return trial;
    }

    /// The height's place in space.
    std::function<Vector3(double)> embed(const std::string& family) {
        const linear::Quaternion tilt = linear::quaternion_exp(gauss(1.0));
        const Vector3 origin = gauss(0.3);
        const double wrist = family == "arc" ? uniform(0.12, 0.3) : uniform(0.3, 0.6);
        const double wide = family == "loop" ? uniform(0.1, 0.35) : 0.0;
        const bool wanders = family == "wandering";
        const Vector3 drift = gauss(wanders ? 0.03 : 0.01), tremor = gauss(2e-4);
        const double slow = uniform(0.15, 0.5), quick = uniform(8, 11),
                     sideways = uniform(0.5, 1.5);
        return [=, height = height_](double t) -> Vector3 {
            // About a wrist, the height is turned into an angle; a loop adds its rate sideways.
            const double h = height.at(t), angle = h / wrist;
            Vector3 p(wrist * (std::cos(angle) - 1), 0.0, wrist * std::sin(angle));
            if (wide > 0) {
                constexpr double kBy = 0.02;
                p.y() = wide * 0.05 * (height.at(t + kBy) - height.at(t - kBy)) / (2 * kBy);
            }
            p.x() += 0.03 * std::sin(2 * M_PI * 0.11 * sideways * t);
            p += drift * std::sin(2 * M_PI * slow * t) + tremor * std::sin(2 * M_PI * quick * t);
            return origin + tilt * p;
        };
    }

    AirSettings settings_;
    std::mt19937 random_;
    Height height_;
    std::vector<double> turns_;
};

}  // namespace percussionist::test
