#include "core/score/tempo_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace percussionist::score {

namespace {

/// Sums of fractions of a beat that miss a whole number by rounding alone are that number.
double snapped(double x) {
    const double whole = std::round(x);
    return std::abs(x - whole) < 1e-6 ? whole : x;
}

/// Bar numbers stay numbers, however absurd the ticks.
int as_bar(double bar) {
    return static_cast<int>(std::clamp(bar, 1.0, 1e9));
}

bool usable(double x) {
    return std::isfinite(x) && x > 0.0;
}

template <class Change>
void put_in_order(std::vector<Change>& changes) {
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.tick < b.tick; });
}

}  // namespace

TempoMap::TempoMap(TickDivision division, std::vector<TempoChange> tempos,
                   std::vector<MetreChange> metres) {
    const bool smpte = division.ticks_per_second != 0.0;
    if (!usable(smpte ? division.ticks_per_second : division.ticks_per_quarter)) {
        throw std::invalid_argument("tempo map: the division must be a finite number above 0");
    }
    put_in_order(tempos);
    put_in_order(metres);
    begin_piece(division, TempoChange{});
    for (const TempoChange& change : tempos) {
        begin_piece(division, change);
    }
    begin_metre(MetreChange{});
    for (const MetreChange& change : metres) {
        begin_metre(change);
    }
}

void TempoMap::begin_piece(const TickDivision& division, const TempoChange& change) {
    if (!usable(change.seconds_per_quarter) || change.tick < 0) {
        throw std::invalid_argument("tempo map: a quarter note must last a time above 0");
    }
    Piece piece;
    piece.tick = static_cast<double>(change.tick);
    if (!pieces_.empty()) {
        const Piece& last = pieces_.back();
        piece.seconds = last.seconds + (piece.tick - last.tick) * last.seconds_per_tick;
        piece.quarters = last.quarters + (piece.tick - last.tick) * last.quarters_per_tick;
    }
    if (division.ticks_per_second != 0.0) {
        piece.seconds_per_tick = 1.0 / division.ticks_per_second;
        piece.quarters_per_tick = piece.seconds_per_tick / change.seconds_per_quarter;
    } else {
        piece.seconds_per_tick = change.seconds_per_quarter / division.ticks_per_quarter;
        piece.quarters_per_tick = 1.0 / division.ticks_per_quarter;
    }
    pieces_.push_back(piece);
}

void TempoMap::begin_metre(const MetreChange& change) {
    if (change.beats < 1 || change.beat_unit < 1 || change.tick < 0) {
        throw std::invalid_argument("tempo map: a bar must have beats");
    }
    Metre metre{quarters(static_cast<double>(change.tick)), 1, change.beats,
                4.0 / change.beat_unit};
    if (!metres_.empty()) {
        const Metre& last = metres_.back();
        const double beats = (metre.quarter - last.quarter) / last.quarters_per_beat;
        metre.bar = as_bar(last.bar + std::ceil(snapped(beats / last.beats)));
    }
    metres_.push_back(metre);
}

const TempoMap::Piece& TempoMap::piece_of(double tick) const {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), tick,
                         [](double value, const Piece& piece) { return value < piece.tick; });
    return *(after - 1);
}

double TempoMap::seconds(Tick tick) const {
    const auto t = static_cast<double>(tick);
    const Piece& piece = piece_of(t);
    return piece.seconds + (t - piece.tick) * piece.seconds_per_tick;
}

double TempoMap::quarters(double tick) const {
    const Piece& piece = piece_of(tick);
    return piece.quarters + (tick - piece.tick) * piece.quarters_per_tick;
}

Position TempoMap::position(Tick tick) const {
    return count(quarters(static_cast<double>(tick)));
}

Position TempoMap::position_at(double seconds) const {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), seconds,
                         [](double value, const Piece& piece) { return value < piece.seconds; });
    const Piece& piece = *(after - 1);
    return count(piece.quarters +
                 (seconds - piece.seconds) / piece.seconds_per_tick * piece.quarters_per_tick);
}

Position TempoMap::count(double quarter) const {
    quarter = std::max(quarter, 0.0);
    constexpr double kRounding = 1e-7;
    const auto after =
        std::upper_bound(metres_.begin() + 1, metres_.end(), quarter + kRounding,
                         [](double value, const Metre& metre) { return value < metre.quarter; });
    const Metre& metre = *(after - 1);
    const double beats =
        std::max(0.0, snapped((quarter - metre.quarter) / metre.quarters_per_beat));
    const double bars = std::floor(beats / metre.beats);
    return {as_bar(metre.bar + bars), 1.0 + beats - bars * metre.beats};
}

}  // namespace percussionist::score
