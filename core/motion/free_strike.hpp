// Strikes on nothing: told from the movement alone, wherever in space it is made.
//
// A strike is a turn or stop of a swing (swing_turn.hpp) that
//  - stands out of noise and idleness: `least_speed`, `least_deceleration`, ten times the noise
//  deep;
//  - is short, `lasts` measured in time and not in size: `longest_stop` for what strikes by itself,
//    known 25 ms after it; up to `longest_turn` if the stick comes back and the player has turned
//    like that before, in the same direction and in less than `memory`. Who reaches for something
//    turns bluntly, stays there, and does not do it again; this is known once the stick is on its
//    way back, `patience` at most;
//  - goes the player's way. Every swing has two turns; strikes are the sharper ones, and where
//  there
//    is no difference the first; that a swing is the faster one counts a little, too. Each way is
//    remembered with its mean sharpness (-log lasts) and the scatter of that; the other way is
//    taken when it is sharper by `other_way` and twice the uncertainty of the difference;
//  - is of the player's kind: no duller than `dull` times the strikes of late (who misses brakes
//    more bluntly), no weaker than `weak` of their speed times deceleration.
// With records further apart than 40 ms nothing is told. A movement whose ways up and down are the
// same, begun at the bottom, may be told at its top.
//
// Follows Marshall, Moynihan, Rath 2002, "The Vodhran", 5: changes in velocity, changes in
// direction and local minima of movement curves. Pure; real-time safe; one detector for each tip.
#pragma once

#include <array>
#include <optional>

#include "core/motion/swing_turn.hpp"

namespace percussionist::motion {

struct FreeStrikeSettings {
    double least_speed = 0.18;        ///< of the swing, at its fastest [m/s]
    double least_deceleration = 4.0;  ///< at its greatest [m/s^2]
    double longest_turn = 0.13;       ///< speed over deceleration, where the stick comes back [s]
    double longest_stop = 0.035;      ///< the same, where nobody knows yet [s]
    double returned = 0.04;           ///< of the swing's depth, to have come back
    double patience = 0.12;           ///< for that [s]
    double weak = 0.02;               ///< of what strikes lately had
    double dull = 1.4;                ///< of what strikes lately lasted
    double other_way = 0.1;           ///< sharper, as a logarithm
    double memory = 2.0;              ///< [s]
    double rest = 0.06;               ///< between strikes at least [s]
};

struct FreeStrike {
    double time = 0.0;                     ///< of the turning point [s]
    double peak_time = 0.0;                ///< of the greatest deceleration [s]
    double speed = 0.0;                    ///< of the swing, at its fastest [m/s]
    double deceleration = 0.0;             ///< at its greatest [m/s^2]
    Vector3 direction = Vector3::UnitX();  ///< of the swing
    Vector3 place = Vector3::Zero();       ///< of the turning point [m]
};

class FreeStrikeDetector {
  public:
    explicit FreeStrikeDetector(const FreeStrikeSettings& settings) : settings_(settings) {}

    std::optional<FreeStrike> add(const PathPoint& tip) noexcept;
    void reset() noexcept;
    void set(const FreeStrikeSettings& settings) { settings_ = settings; }

  private:
    /// Turns the same way, lately.
    struct Way {
        int count = 0;
        double power = 0.0, log_speed = 0.0, sharpness = 0.0, squares = 0.0;
        void add(const SwingTurn& turn, double new_sharpness) noexcept;
        double variance() const noexcept;
    };

    void update_noise() noexcept;
    std::optional<FreeStrike> judge(std::size_t at) noexcept;
    std::optional<FreeStrike> wait() noexcept;
    std::optional<FreeStrike> decide(const SwingTurn& turn) noexcept;
    bool stands_out(const SwingTurn& turn) const noexcept;
    bool was_before(const SwingTurn& turn) const noexcept;
    bool is_players(const SwingTurn& turn) noexcept;
    bool is_other_way(const Way& own) const noexcept;
    SwingMeter meter() const { return {path_, noise_, begun_}; }

    FreeStrikeSettings settings_;
    RecentPath path_;
    Recent<double, 32> residuals_;
    double noise_ = 0.0;                // [m]
    Recent<SwingTurn, 6> turns_;        // that stood out
    std::optional<SwingTurn> pending_;  // that may still come back
    std::array<Way, 2> ways_;           // of strikes, and against it
    Vector3 way_ = Vector3::UnitX();
    double judged_ = -1e9;  // up to this point [s]
    double begun_ = -1e9;   // the swing that is going on [s]
    double struck_ = -1e9;  // last [s]
};

}  // namespace percussionist::motion
