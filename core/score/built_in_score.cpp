#include <algorithm>

#include "core/score/score.hpp"

namespace percussionist::score {

namespace {

constexpr double kPp = 0.14, kP = 0.26, kMp = 0.40, kMf = 0.53, kF = 0.70, kFf = 0.86, kFff = 1.0;
constexpr double kSecondsPerBeat = 60.0 / 112.0;
constexpr int kBeats = 4;  ///< in a bar
/// Two keys, so that both hands striking at once are two notes and not one that came twice.
constexpr int kDrum = 41;
constexpr int kDrumOtherHand = 43;

class Composer {
  public:
    Composer() {
        constexpr double kTicks = 480.0;
        score_.title = "Intrada for one drum";
        score_.tempo = TempoMap({.ticks_per_quarter = kTicks}, {{0, kSecondsPerBeat}}, {});
    }

    void strike(int bar, double beat, double velocity, int instrument = kDrum) {
        add(((bar - 1) * kBeats + beat - 1.0) * kSecondsPerBeat, velocity, instrument);
    }

    /// A softer stroke of the other hand just before.
    void flam(int bar, double beat, double velocity) {
        constexpr double kBefore = 0.03;
        const double time = ((bar - 1) * kBeats + beat - 1.0) * kSecondsPerBeat;
        add(time - kBefore, 0.45 * velocity, kDrum);
        add(time, velocity, kDrum);
    }

    void both_hands(int bar, double beat, double velocity) {
        strike(bar, beat, velocity);
        strike(bar, beat, velocity, kDrumOtherHand);
    }

    /// `count` even strokes over `beats`, their loudness going from one to the other.
    void run(int bar, double beat, double beats, int count, double from, double to) {
        for (int i = 0; i < count; ++i) {
            const double part = static_cast<double>(i) / count;
            strike(bar, beat + beats * part, from + (to - from) * part);
        }
    }

    /// Makes the last `back`-th note an accent.
    void accent(int back, double velocity) {
        score_.notes[score_.notes.size() - back].velocity = velocity;
    }

    Score finish(double ring) {
        std::stable_sort(score_.notes.begin(), score_.notes.end(),
                         [](const Note& a, const Note& b) { return a.time < b.time; });
        score_.duration = score_.notes.back().time + ring;
        return std::move(score_);
    }

  private:
    void add(double time, double velocity, int instrument) {
        Note note;
        note.time = time;
        note.velocity = velocity;
        note.instrument = instrument;
        note.position = score_.tempo.position_at(time);
        score_.notes.push_back(note);
    }

    Score score_;
};

/// A call, its answer from far away, and again, nearer.
void call(Composer& c) {
    c.both_hands(1, 1, kFf);
    c.run(1, 3, 2, 4, kPp, kP);
    c.flam(2, 1, kFf);
    c.flam(2, 1.75, kF);
    c.run(2, 3, 1, 4, kPp, kPp);
    c.run(2, 4, 1, 2, kP, kMp);
}

/// A march: long, short, and the short ones grow.
void march(Composer& c) {
    for (const int bar : {3, 4}) {
        const double more = bar == 4 ? 0.08 : 0.0;
        c.strike(bar, 1, kF + more);
        c.strike(bar, 1.75, kMp + more);
        c.strike(bar, 2, kMf + more);
        c.strike(bar, 2.5, kMp + more);
        c.strike(bar, 3, kF + more);
        c.strike(bar, 3.5, kMp + more);
        c.strike(bar, 3.75, kMp + more);
    }
    c.flam(3, 4, kMf);
    c.run(4, 4, 1, 3, kMf, kF);
}

/// Three against the beat, then three, three and two, ever louder; it breaks off.
void chase(Composer& c) {
    c.run(5, 1, 4, 12, kP, kMf);
    for (const int back : {12, 8, 4}) {
        c.accent(back, kF);
    }
    c.run(6, 1, 4, 16, kMp, kF);
    for (const int back : {16, 13, 10, 8, 5, 2}) {
        c.accent(back, kFf);
    }
    c.flam(7, 1, kFf);
}

/// A roll out of nothing, seven strokes a beat, to a blow; then nothing again.
void roll(Composer& c) {
    c.run(7, 3, 2, 14, 0.06, kPp);
    c.run(8, 1, 4 - 1.0 / 7, 27, kPp, kFf);
    c.both_hands(9, 1, kFff);
    c.strike(9, 4, kPp);
    c.strike(9, 4.5, kPp);
}

/// The march as an echo; strokes crowd together; all that is left.
void ending(Composer& c) {
    c.strike(10, 1, kMp);
    c.strike(10, 1.75, kP);
    c.strike(10, 2, kMp);
    c.strike(10, 2.5, kP);
    c.flam(10, 3, kMp);
    c.run(10, 3.5, 0.5, 2, kP, kP);
    c.flam(10, 4, kMp);
    c.strike(11, 1, kMf);
    c.run(11, 2, 1, 2, kMp, kMf);
    c.run(11, 3, 1, 3, kMp, kMf);
    c.run(11, 4, 1, 4, kMf, kF);
    c.run(12, 1, 1, 6, kMf, kF);
    c.run(12, 2, 1, 6, kMf, kF);
    c.run(12, 3, 1, 7, kF, kFf);
    c.flam(12, 4.25, kFf);
    c.both_hands(13, 1, kFff);
}

}  // namespace

Score built_in_score() {
    Composer composer;
    call(composer);
    march(composer);
    chase(composer);
    roll(composer);
    ending(composer);
    constexpr double kRing = 2.5;
    return composer.finish(kRing);
}

}  // namespace percussionist::score
