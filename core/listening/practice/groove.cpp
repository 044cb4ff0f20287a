#include "core/listening/practice/groove.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace percussionist::listening::practice {

namespace {

/// One bar of one piece: how likely a stroke is at each place, and how loud.
struct Line {
    Piece piece = Piece::kick;
    std::vector<double> chance;
    std::vector<double> velocity;
};

class Drummer {
  public:
    explicit Drummer(Dice& dice)
        : dice_(dice),
          beat_(60.0 / dice.log_uniform(65.0, 190.0)),
          beats_(dice.chance(0.85) ? 4 : 3),
          swung_(dice.chance(0.25)),
          per_beat_(swung_ ? 3 : 4),
          looseness_(dice.log_uniform(0.001, 0.012)),
          dynamics_(dice.uniform(0.02, 0.15)),
          phrase_(dice.chance(0.15)  ? 1
                  : dice.chance(0.4) ? 2
                                     : 4),
          crashing_(dice.uniform(0.1, 0.9)) {
        time_keeping();
        kick();
        snare();
        colours();
        for (double& offset : offsets_) offset = 0.006 * dice_.normal();
    }

    Groove play(double duration) {
        const double bar = beat_ * beats_;
        int count = 0;
        for (double at = dice_.uniform(0.0, 0.4); at < duration; at += bar) {
            ++count;
            if (count > 1 && dice_.chance(0.04)) continue;  // a break
            const bool fills = count % phrase_ == 0 && dice_.chance(0.6);
            const bool crashes = count % phrase_ == 1 % phrase_ && dice_.chance(crashing_);
            const std::size_t end = fills ? place_of_fill() : places();
            play_bar(at, end, crashes);
            fill(at, end);
            if (crashes) hit(at, 0, crash_, 0.9);
            if (dice_.chance(0.1)) change_hands();
        }
        std::erase_if(groove_.strokes,
                      [&](const Stroke& s) { return s.time >= duration - 0.3 || s.time < 0.0; });
        std::sort(groove_.strokes.begin(), groove_.strokes.end(),
                  [](const Stroke& a, const Stroke& b) { return a.time < b.time; });
        groove_.beat = beat_;
        groove_.beats = beats_;
        return groove_;
    }

  private:
    [[nodiscard]] std::size_t places() const {
        return static_cast<std::size_t>(beats_ * per_beat_);
    }
    std::size_t place_of_fill() {
        return places() - static_cast<std::size_t>(per_beat_) * (dice_.chance(0.3) ? 2 : 1);
    }

    static bool keeps_time(Piece piece) {
        return piece == Piece::closed_hat || piece == Piece::open_hat || piece == Piece::ride;
    }

    Line& line(Piece piece) {
        lines_.push_back(
            {piece, std::vector<double>(places(), 0.0), std::vector<double>(places(), 0.8)});
        return lines_.back();
    }
    void put(Line& line, std::size_t place, double chance, double velocity) {
        line.chance[place % places()] = chance;
        line.velocity[place % places()] = velocity;
    }

    void time_keeping() {
        const std::array<Piece, 5> hands = {Piece::closed_hat, Piece::ride, Piece::open_hat,
                                            Piece::low_tom, Piece::crash};
        const std::array<double, 5> likely = {0.6, 0.87, 0.93, 0.97, 1.0};
        const double which = dice_.uniform();
        Line& keeping = line(hands[static_cast<std::size_t>(
            std::upper_bound(likely.begin(), likely.end() - 1, which) - likely.begin())]);
        const auto step = static_cast<std::size_t>(per_beat_);
        const double style = dice_.uniform();
        const double accent = dice_.uniform(0.75, 0.95);
        const double weak = dice_.uniform(0.4, 0.85);
        if (style < 0.13) return;  // none keeps time
        for (std::size_t place = 0; place < places(); ++place) {
            const std::size_t within = place % step;
            const bool half = swung_ ? within == 2 : within == 2;
            if (within == 0 && style > 0.19) put(keeping, place, 0.98, accent);
            if (half && (style < 0.19 || style > 0.3)) {
                const bool skips = swung_ && style > 0.6 && (place / step) % 2 == 0;
                put(keeping, place, skips ? 0.1 : 0.97, style < 0.19 ? accent : weak);
            }
            if (!swung_ && within % 2 == 1)
                put(keeping, place, style > 0.78 ? 0.97 : 0.03, weak * 0.85);
            if (swung_ && within == 1 && style > 0.85) put(keeping, place, 0.9, weak * 0.85);
        }
        if (keeping.piece == Piece::closed_hat && dice_.chance(0.45)) {
            opening_ = dice_.whole(places());
        }
        if (keeping.piece != Piece::closed_hat && dice_.chance(0.6)) {  // the foot, off the beat
            Line& foot = line(Piece::pedal_hat);
            const bool every = dice_.chance(0.3);
            for (std::size_t beat = every ? 0 : 1; beat < static_cast<std::size_t>(beats_);
                 beat += every ? 1 : 2) {
                put(foot, beat * step, 0.95, dice_.uniform(0.5, 0.9));
            }
        }
    }

    void kick() {
        Line& foot = line(Piece::kick);
        const auto step = static_cast<std::size_t>(per_beat_);
        const bool every_beat = dice_.chance(0.2);
        const bool with_snare = dice_.chance(0.15);
        const double busy = dice_.uniform(0.0, 0.3);
        const double sure = dice_.uniform(0.9, 1.0);
        for (std::size_t place = 0; place < places(); ++place) {
            const std::size_t beat = place / step;
            const bool on_beat = place % step == 0;
            const bool half = place % step == 2;
            if (on_beat && (every_beat || beat == 0 || (beat % 2 == 0 && dice_.chance(0.6)) ||
                            (beat % 2 == 1 && with_snare))) {
                put(foot, place, sure, 0.9);
            } else if (dice_.chance(busy * (half ? 2.0 : 1.0))) {
                put(foot, place, dice_.chance(0.7) ? sure : 0.3, dice_.uniform(0.65, 0.95));
            }
        }
    }

    void snare() {
        const auto step = static_cast<std::size_t>(per_beat_);
        const double style = dice_.uniform();
        const Piece stick = style < 0.12 ? Piece::side_stick : Piece::snare;
        Line& hand = line(stick);
        if (style > 0.95) return;
        for (std::size_t beat = 1; beat < static_cast<std::size_t>(beats_); beat += 2)
            put(hand, beat * step, 0.98, 0.92);
        if (style > 0.85 && beats_ == 4) {  // half time
            hand.chance.assign(places(), 0.0);
            put(hand, 2 * step, 0.98, 0.92);
        }
        if (dice_.chance(0.5)) {  // ghosts
            Line& ghosts = line(Piece::snare);
            const double quiet = dice_.uniform(0.25, 0.6);
            const double density = dice_.uniform(0.05, 0.4);
            for (std::size_t place = 0; place < places(); ++place) {
                if (hand.chance[place] < 0.5 && dice_.chance(density))
                    put(ghosts, place, dice_.uniform(0.1, 0.9), quiet);
            }
        }
    }

    void colours() {
        crash_ = dice_.chance(0.7) ? Piece::crash : Piece::second_crash;
        for (const Piece piece :
             {Piece::shaken_percussion, Piece::hand_percussion, Piece::bell, Piece::low_tom}) {
            const bool rare = piece == Piece::bell || piece == Piece::low_tom;
            if (!dice_.chance(rare ? 0.06 : 0.14)) continue;
            const bool regular = dice_.chance(0.5);
            Line& colour = line(piece);
            for (std::size_t place = 0; place < places(); ++place) {
                if (dice_.chance(regular ? (place % 2 == 0 ? 0.8 : 0.3) : 0.15))
                    put(colour, place, 0.9, dice_.uniform(0.5, 0.9));
            }
        }
        chaos_ = dice_.chance(0.1) ? dice_.uniform(0.5, 6.0) : dice_.chance(0.3) ? 0.3 : 0.0;
    }

    /// Ride instead of hat, or back.
    void change_hands() {
        for (Line& line : lines_) {
            if (line.piece == Piece::closed_hat) {
                line.piece = Piece::ride;
            } else if (line.piece == Piece::ride) {
                line.piece = Piece::closed_hat;
            }
        }
    }

    /// The hand that crashes on the first beat leaves out there what it keeps time on.
    void play_bar(double at, std::size_t until, bool crashes) {
        for (const Line& line : lines_) {
            for (std::size_t place = 0; place < until; ++place) {
                if (!dice_.chance(line.chance[place])) continue;
                if (crashes && place == 0 && keeps_time(line.piece)) continue;
                const bool opens =
                    line.piece == Piece::closed_hat && place == opening_ && dice_.chance(0.7);
                hit(at, place, opens ? Piece::open_hat : line.piece, line.velocity[place]);
            }
        }
        for (double t = 0.0; chaos_ > 0.0 && t < beat_ * beats_;
             t += dice_.uniform(0.0, 2.0 / chaos_)) {
            groove_.strokes.push_back(
                {at + t, static_cast<Piece>(dice_.whole(kPieces)), dice_.uniform(0.4, 1.0)});
        }
    }

    void fill(double at, std::size_t from) {
        const std::array<Piece, 5> path = {Piece::snare, Piece::high_tom, Piece::middle_tom,
                                           Piece::low_tom, Piece::kick};
        for (std::size_t place = from; place < places(); ++place) {
            const std::size_t along = (place - from) * 4 / (places() - from);
            if (dice_.chance(0.8))
                hit(at, place, path[dice_.chance(0.3) ? dice_.whole(5) : along],
                    dice_.uniform(0.6, 1.0));
        }
    }

    void hit(double bar, std::size_t place, Piece piece, double velocity) {
        const double time = bar + static_cast<double>(place) * beat_ / per_beat_ +
                            offsets_[static_cast<std::size_t>(piece)] + looseness_ * dice_.normal();
        groove_.strokes.push_back(
            {time, piece, std::clamp(velocity + dynamics_ * dice_.normal(), 0.15, 1.0)});
        if (piece == Piece::snare && velocity > 0.7 && dice_.chance(0.01)) {  // a flam
            groove_.strokes.push_back({time - 0.035, piece, 0.5});
        }
    }

    Dice& dice_;
    double beat_;
    int beats_;
    bool swung_;
    int per_beat_;
    double looseness_, dynamics_;
    int phrase_;       ///< bars, at whose ends are fills and at whose beginnings crashes
    double crashing_;  ///< how likely those are
    std::size_t opening_ = 1000;
    Piece crash_ = Piece::crash;
    double chaos_ = 0.0;
    std::array<double, kPieces> offsets_{};
    std::deque<Line> lines_;  // whose lines stay where they are
    Groove groove_;
};

}  // namespace

Groove throw_groove(double duration, Dice& dice) {
    return Drummer(dice).play(duration);
}

}  // namespace percussionist::listening::practice
