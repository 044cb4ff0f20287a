// From notes to the strokes of two hands on one drum, leaving out nothing unsaid.
//
// What a hand can do: strike at most every `min_interval`. Notes within 12 ms belong together (one
// group); a group has at most two strokes, one a hand. Flams, two notes 15 to 40 ms apart, fall to
// different hands because of `min_interval`.
//
// Which hand plays what is found by dynamic programming over the groups. The state is the last
// stroke of each hand, forgotten after a while; the cost is, first, the notes left out and, among
// equals, awkwardness: a hand that repeats, the more the faster (so that fast passages
// alternate), the left hand on a downbeat, the loudness of what is left out. Groups are at least
// 12 ms apart, so that the number of states has a fixed bound and the time grows linearly.
//
// Which notes go when a group has too many: the loudest two are kept; of equally loud ones the
// lower key, that is, in General MIDI: kick, snare, hats and toms, cymbals.
//
// How loud: the speed of the stick when it strikes grows exponentially with the note's velocity,
// equal steps of velocity being equal steps in decibels. At velocities 67, 95 and 126 that gives
// the 1.9, 2.8 and 4.4 m/s of timpanists' legato strokes, accents and vertical accents. Where a
// score tells nuances, the velocity is the dynamic, and the nuance makes the stroke faster or
// slower.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/score/score.hpp"

namespace percussionist::score {

enum Hand { kLeft = 0, kRight = 1 };

struct Stroke {
    double time = 0.0;      ///< of the impact [s] at tempo 1
    int hand = kRight;      ///< 0 left, 1 right
    int drum = 0;           ///< 0: the one drum
    double speed = 0.0;     ///< of the stick's tip at impact [m/s]
    double height = 0.0;    ///< from which the tip comes down [m]
    double velocity = 0.0;  ///< of the note, 0..1: its dynamic
    std::size_t note = 0;   ///< its index in the score
    Position position;      ///< bar and beat
    Nuance nuance = Nuance::legato;
};

enum class Why {
    double_event,   ///< the same instrument had just been struck, within a millisecond
    not_asked_for,  ///< the options name the instruments to play, and this is none of them
    third_at_once,  ///< two hands play at this instant already
    too_fast,       ///< no hand could have got there, or not without losing more notes
};

struct LeftOut {
    std::size_t note = 0;
    double time = 0.0;  ///< [s]
    Position position;
    Why why = Why::too_fast;
    std::string reason;  ///< in words, with the numbers
};

struct PlanOptions {
    double min_interval = 0.098;   ///< between two strokes of one hand [s]
    std::vector<int> instruments;  ///< those to play; empty: all
};

struct StrokePlan {
    std::vector<Stroke> strokes;    ///< in order of time
    std::vector<LeftOut> left_out;  ///< in order of time
    std::vector<LeftOut> doubles;   ///< events that came twice
};

/// Every note of the score is in exactly one of the plan's three lists. Throws
/// std::invalid_argument if min_interval is not above 0, or a note's time or velocity cannot be.
StrokePlan plan_strokes(const Score& score, const PlanOptions& options = {});

/// "bar 3 beat 2.50 (12.345 s) closed hat: faster than ..." for a person to read.
std::string describe(const LeftOut& left_out, const Score& score);

/// Impact speed [m/s] for a velocity in 0..1: 0.7 at 1/127, 4.5 at 1, strictly increasing.
double impact_speed(double velocity);
/// The same of a nuance, at most 6 m/s.
double impact_speed(double velocity, Nuance nuance);
/// The other way: the velocity of a note that is struck at a speed above 0 [m/s]; of one softer
/// than the softest note below 1/127.
double velocity_of_impact(double speed);

/// The height [m] a player with all the time in the world prepares a stroke of that speed from.
double preparation_height(double speed);

/// The height [m] a hand can rise to and strike from at `speed` when it struck `interval` [s] ago:
/// up and down again at a mean of half that speed, after the contact.
double reachable_height(double speed, double interval);

}  // namespace percussionist::score
