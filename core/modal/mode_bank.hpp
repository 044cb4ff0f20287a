// A bank of modes, each an oscillator q'' + 2 s q' + w^2 q = f phi / m, moved exactly from sample
// to sample under a force constant in between. All the loops over modes are here.
//
// A mode's state is q and y = (q' + s q) / wd, with wd = sqrt(w^2 - s^2). In these its free motion
// over h seconds turns (q, y) by the angle wd h and shrinks it by exp(-s h), whatever happens to w
// and s meanwhile: never unstable, and its poles are exact up to half the sample rate. A force f
// moves the point about which it turns from 0 to q = f phi / (m w^2).
//
// The sums over modes are taken in one fixed order, so that the same strokes give the same samples
// to the last bit in blocks of any size and on any processor. A bank's size is rounded up to whole
// groups of kGroup modes: vectors of weights have padded() values, zeros at the end.
//
// The constructor allocates; everything else is noexcept and may be called in the audio thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace percussionist::modal {

class ModeBank {
  public:
    static constexpr std::size_t kGroup = 8;
    static constexpr std::size_t kMostAtOnce = 64;  ///< samples in one call of ring()

    struct Mode {
        double angular_frequency = 0.0;  ///< w [rad/s]; 0: a mode that never moves
        double loss = 0.0;               ///< s [1/s], below w
        double mass = 1.0;               ///< m [kg]
    };

    ModeBank(std::size_t size, double period);

    std::size_t size() const { return size_; }
    std::size_t padded() const { return q_.size(); }

    /// Sets mode k; its displacement and velocity stay as they are, unless it is to be still.
    void set(std::size_t k, const Mode& mode) noexcept;
    /// Takes over the displacements and velocities of another bank, as far as both have modes.
    void continue_from(const ModeBank& other) noexcept;

    /// One sample without a force; answers the displacement() then.
    double swing(std::span<const double> phi) noexcept;
    /// What a constant force during the sample that swing() has made adds to it.
    void push(double force, std::span<const double> phi) noexcept;
    /// sum phi q that a force of 1 N shared out by `other` makes in one sample [m/N].
    double compliance(std::span<const double> phi, std::span<const double> other) const noexcept;

    /// sum phi q [m].
    double displacement(std::span<const double> phi) const noexcept;

    /// Weights that read the velocity sum phi q', for the modes as they are set now.
    struct VelocityWeights {
        std::vector<double> q, y;
    };
    void set_weights(std::span<const double> phi, VelocityWeights& weights) const noexcept;
    double velocity(const VelocityWeights& weights) const noexcept;
    /// At most kMostAtOnce times swing() and velocity(), to the last bit, and faster.
    void ring(const VelocityWeights& weights, std::span<double> velocities) noexcept;

    double energy() const noexcept;  ///< kinetic plus potential [J]
    void rest() noexcept;
    /// To rest with those modes whose numbers would soon be denormal and slow.
    void rest_the_faint() noexcept;

  private:
    double rate(std::size_t k) const noexcept {
        return damped_[k] * y_[k] - modes_[k].loss * q_[k];
    }

    std::size_t size_;
    double period_;
    std::vector<Mode> modes_;
    std::vector<double> damped_;  // wd [rad/s]
    std::vector<double> q_, y_;
    std::vector<double> cos_, sin_;    // of the turn, times its shrinking
    std::vector<double> to_q_, to_y_;  // what f phi adds within one sample
};

}  // namespace percussionist::modal
