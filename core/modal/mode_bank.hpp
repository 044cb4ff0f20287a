// A bank of modes, each an oscillator q'' + 2 s q' + w^2 q = f phi / m, moved exactly from sample
// to sample under a force constant in between. Its loops over modes are in mode_loops.hpp.
//
// A mode's state is q and y = (q' + s q) / wd, with wd = sqrt(w^2 - s^2). In these its free motion
// over h seconds turns (q, y) by the angle wd h and shrinks it by exp(-s h), whatever happens to w
// and s meanwhile: never unstable, and its poles are exact up to half the sample rate. A force f
// moves the point about which it turns from 0 to q = f phi / (m w^2).
//
// The bank is asked what will be read in the next samples if nothing acts, ring(), which leaves it
// where it is, and then moved on over them by advance(). What forces in between have added is given
// to it afterwards, give(); what each adds to the readings until then follows from answer(). So a
// mode's numbers are fetched once in many samples: a bank larger than the cache is as fast as
// arithmetic, in double precision; in float it would be half as large, and not faster by more than
// that of the arithmetic. Each reading of a mode follows its own recurrence p[n+1] = 2 r cos p[n] -
// r^2 p[n-1] (r, cos of one sample's turn), and so does what forces add (Goertzel, "An algorithm
// for the evaluation of finite trigonometric series", 1958): half the work of turning the mode.
// From n samples rounding grows as n^2, to some 1e-14 in a span.
//
// The sums over modes are taken in one fixed order and nothing is contracted to fused operations:
// the same calls give the same bits on any processor. A bank's size is rounded up to whole groups
// of kGroup modes: vectors of weights have padded() values, zeros at the end. Modes beyond the last
// that moves are skipped.
//
// The constructor allocates; everything else is noexcept and may be called in the audio thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/modal/aligned.hpp"
#include "core/modal/mode_loops.hpp"

namespace percussionist::modal {

class ModeBank {
  public:
    static constexpr std::size_t kGroup = Modes::kGroup;
    static constexpr std::size_t kSpan = 16;   ///< samples that advance() passes at once,
    static constexpr std::size_t kChunk = 64;  ///< or these; the most in one call

    struct Mode {
        double angular_frequency = 0.0;  ///< w [rad/s]; 0: a mode that never moves
        double loss = 0.0;               ///< s [1/s], below w
        double mass = 1.0;               ///< m [kg]
    };

    /// Weights of q and y that read a sum over modes, such as a velocity.
    struct Weights {
        Values q, y;
        Values force;  ///< of f phi, which a reading of accelerations needs; else empty
    };

    /// `loops` other than the best are for tests and measurements.
    ModeBank(std::size_t size, double period, const ModeLoops& loops = ModeLoops::best());

    std::size_t size() const { return size_; }
    std::size_t padded() const { return modes_.size(); }
    std::size_t moving() const { return moving_; }  ///< modes beyond are at rest

    /// Sets mode k; its displacement and velocity stay as they are, unless it is to be still.
    void set(std::size_t k, const Mode& mode) noexcept;
    /// Takes over the displacements and velocities of another bank, as far as both have modes: mode
    /// k those of the other's k + shift.
    void continue_from(const ModeBank& other, long shift = 0) noexcept;

    /// Takes over the displacements and velocities of a bank of the same modes, of another period.
    void take_motion(const ModeBank& other) noexcept;

    /// So many samples (at most kChunk) without a force.
    void advance(std::size_t samples) noexcept;
    /// What forces [N], constant during each of the samples just passed and shared out by phi, have
    /// added.
    void give(std::span<const double> forces, std::span<const double> phi) noexcept;

    /// advance(1), and in `middle` weights (q before + q after): the gradient of sum weights q^2
    /// there. Answers sum middle (q after - q before).
    double swing_about(std::span<const double> weights, std::span<double> middle) noexcept;

    double displacement(std::span<const double> phi) const noexcept;  ///< sum phi q [m]
    double reading(const Weights& weights) const noexcept;
    double square_sum(std::span<const double> weights) const noexcept;  ///< sum weights q^2
    /// Weights that read the velocity sum phi q', for the modes as they are set now.
    void read_velocity(std::span<const double> phi, Weights& weights) const noexcept;
    /// Weights that read sum over k of a[k] (q'' of mode k), and the same a quarter period later.
    void read_acceleration(std::span<const double> in_phase, std::span<const double> later,
                           Weights& weights) const noexcept;

    /// The reading, or sum phi q, after each of the next samples (at most kChunk), if none is
    /// forced.
    void ring(const Weights& weights, std::span<double> readings) const noexcept;
    void ring(std::span<const double> phi, std::span<double> displacements) const noexcept;
    /// What 1 N during one sample, shared out by phi, adds to the reading, or to sum other q, after
    /// this sample and those that follow (at most kChunk in all).
    void answer(std::span<const double> phi, const Weights& weights,
                std::span<double> readings) const noexcept;
    void answer(std::span<const double> phi, std::span<const double> other,
                std::span<double> displacements) const noexcept;
    /// The part of answer() that a reading of accelerations has during the sample alone.
    static double direct(const Weights& weights, std::span<const double> phi) noexcept;

    const Mode& mode(std::size_t k) const { return modes_[k]; }

    double energy() const noexcept;  ///< kinetic plus potential [J]
    void rest() noexcept;
    /// Modes with less than `energy` [J] come to rest.
    void retire(double energy) noexcept;

  private:
    double& at(Slot row, std::size_t k) noexcept {
        return block_[k / kGroup * Modes::kRecord + row * kGroup + k % kGroup];
    }
    double at(Slot row, std::size_t k) const noexcept {
        return const_cast<ModeBank*>(this)->at(row, k);
    }
    double rate(std::size_t k) const noexcept {
        return damped_[k] * at(kY, k) - modes_[k].loss * at(kQ, k);
    }
    double mode_energy(std::size_t k) const noexcept;
    void answer(const double* phi, const double* a, const double* b,
                std::span<double> readings) const noexcept;
    /// The loops' view. Those that only read are given it too.
    Modes moving_modes() const noexcept;
    Modes all_modes() const noexcept;

    const ModeLoops* loops_;
    std::size_t size_;
    double period_;
    std::size_t moving_ = 0;
    std::vector<Mode> modes_;
    std::vector<double> damped_;  // wd [rad/s]
    Values block_;
};

}  // namespace percussionist::modal
