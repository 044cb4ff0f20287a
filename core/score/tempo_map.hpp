// When a tick of a score sounds, and in which bar and on which beat it stands.
//
// Ticks are the score's own unit of time: a fraction of a quarter note whose length changes with
// the tempo, or (SMPTE) a fixed fraction of a second. Between two changes of tempo everything is
// linear, so that the map is a list of straight pieces, each joined to the end of the last.
//
// Bars and beats count from 1. A beat is the lower number of the time signature (an eighth in
// 6/8), a change of signature opens a new bar, and before the first one the metre is 4/4. Where
// ticks are SMPTE time, tempo changes do not move notes and serve for counting bars alone.
//
// Plain values, pure functions; the constructor allocates.
#pragma once

#include <cstdint>
#include <vector>

namespace percussionist::score {

using Tick = std::int64_t;

/// Ticks in a quarter note, or (if ticks_per_second is above 0) in a second.
struct TickDivision {
    double ticks_per_quarter = 480.0;
    double ticks_per_second = 0.0;
};

struct TempoChange {
    Tick tick = 0;
    double seconds_per_quarter = 0.5;
};

struct MetreChange {
    Tick tick = 0;
    int beats = 4;      ///< in a bar
    int beat_unit = 4;  ///< 4: a beat is a quarter note, 8: an eighth
};

struct Position {
    int bar = 1;
    double beat = 1.0;
};

class TempoMap {
  public:
    TempoMap() : TempoMap(TickDivision{}, {}, {}) {}

    /// Changes may come in any order; of several at one tick the last one given holds. Throws
    /// std::invalid_argument for a division, tempo or metre that cannot be.
    TempoMap(TickDivision division, std::vector<TempoChange> tempos,
             std::vector<MetreChange> metres);

    [[nodiscard]] double seconds(Tick tick) const;
    [[nodiscard]] Position position(Tick tick) const;
    [[nodiscard]] Position position_at(double seconds) const;

  private:
    struct Piece {
        double tick = 0.0;
        double seconds = 0.0;
        double quarters = 0.0;
        double seconds_per_tick = 0.0;
        double quarters_per_tick = 0.0;
    };
    struct Metre {
        double quarter = 0.0;
        int bar = 1;
        int beats = 4;
        double quarters_per_beat = 1.0;
    };

    void begin_piece(const TickDivision& division, const TempoChange& change);
    void begin_metre(const MetreChange& change);
    [[nodiscard]] const Piece& piece_of(double tick) const;
    [[nodiscard]] double quarters(double tick) const;
    [[nodiscard]] Position count(double quarter) const;

    std::vector<Piece> pieces_;
    std::vector<Metre> metres_;
};

}  // namespace percussionist::score
