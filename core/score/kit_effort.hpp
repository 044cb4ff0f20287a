// What it costs a drummer's hand to play a hit, after what both hands did last.
//
// The cost is a sum of parts, in units of about a slight awkwardness:
//     way         (v / 6 m/s)^2, v the distance from the hand's last spot over the gap but for
//                 `settling`; faster than the kit's `speed` cannot be
//     repeat      (0.16 s / gap)^3 of the hand's own gap, so that fast passages alternate
//     pair        against the pair's preference: 3 exp(-q / 0.2 s), q the time since the other
//                 hand's hit; five times that at one instant
//     preference  against the event's own hand: 1.4, less what the pair has to say
//     lead        the left hand on a beat
// A hand repeats after `interval`, or once after `bounce` on the object where it is: the stick
// bounces. Arms do not cross within 0.25 s of each other's hits but where a pair asks for it. The
// order of the parts is that of Kragtwijk, Nijholt and Zwiers, "An animated virtual
// drummer" (2001), 3.3; the numbers are our choice.
//
// The constructor allocates; the rest does not. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/score/kit.hpp"

namespace percussionist::score {

/// What is to be struck by a hand.
struct HandHit {
    double time = 0.0;      ///< [s]
    double velocity = 0.5;  ///< 0..1
    double beat = 1.0;      ///< in its bar, from 1
    std::size_t event = 0;
};

/// What a hand did last; no hit: long ago.
struct HandPast {
    const HandHit* hit = nullptr;
    bool bounced = false;  ///< it was the second of a bounced pair
};

/// Why a hand cannot play a hit.
enum class Obstacle { none, reach, too_soon, too_far, crossing };

struct Effort {
    Obstacle obstacle = Obstacle::none;
    double way = 0.0, repeat = 0.0, pair = 0.0, preference = 0.0, lead = 0.0;
    bool bounces = false;
    [[nodiscard]] bool possible() const { return obstacle == Obstacle::none; }
    [[nodiscard]] double total() const { return way + repeat + pair + preference + lead; }
};

class HandEffort {
  public:
    /// What was longer ago is forgotten [s].
    static constexpr double kMemory = 0.8;
    /// Hits this close together are one instant [s].
    static constexpr double kAtOnce = 0.012;
    /// Arms that cross within this time cross each other [s].
    static constexpr double kCrossingWithin = 0.25;

    explicit HandEffort(const Kit& kit);

    /// What the hand's own past has to do with it: way, repeat, reach, lead.
    [[nodiscard]] Effort alone(const HandHit& hit, Limb hand, const HandPast& own) const;
    /// What the other hand's has: pair, preference, crossing.
    [[nodiscard]] Effort beside(const HandHit& hit, Limb hand, const HandPast& other) const;
    /// Both.
    [[nodiscard]] Effort of(const HandHit& hit, Limb hand, const HandPast& own,
                            const HandPast& other) const;
    /// The arms lie across, and no pair asks for it.
    [[nodiscard]] bool crossed(std::size_t left_event, std::size_t right_event) const {
        return crossed_[left_event * size_ + right_event];
    }
    /// From spot to spot of one hand [m].
    [[nodiscard]] double distance(Limb hand, std::size_t from, std::size_t to) const {
        return (spots_[index(hand)][to] - spots_[index(hand)][from]).norm();
    }

  private:
    void move(const HandHit& hit, Limb hand, const HandPast& own, Effort& effort) const;

    const Kit& kit_;
    std::size_t size_;
    std::array<std::vector<Vector3>, 2> spots_;
    std::vector<bool> crossed_;
};

}  // namespace percussionist::score
