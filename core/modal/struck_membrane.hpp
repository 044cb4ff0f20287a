// A membrane struck by mallets: a bank of modes and the felts that press on it, solved together at
// every sample. It is the drum that sounds in Pd and the head the simulated sticks fall on.
//
// During a sample each contact's force f is constant, and everything moves exactly as it then must:
//     the head's modes      q'' + 2 s q' + w^2 q = -f phi(point) / m      (a turn and a shift)
//     the striker           z'' = acceleration + f / mass                 (a parabola)
// The force's work is therefore exact on both sides, and with the discrete gradient of mallet.hpp
// the energy of head, felt and strikers stays the same to rounding when nothing is lossy, and never
// grows when something is. The turn is of length below 1 for whatever frequency and loss: no
// setting, nor its change while the head swings, can make it unstable. The same phi shares the
// force out and reads the displacement back, so that what A feels of B is what B feels of A
// (reciprocity).
//
// Frame: along the head's normal, z > 0 above the head on the striker's side, the head at rest at
// 0. A striker touches where z is below the head's displacement at its place. Beyond the rim the
// head does not move: there a striker meets a rigid wall.
//
// The constructor, tune() and place() allocate or evaluate Bessel functions: 0.2 ms for 120 modes,
// never throwing once constructed except for arguments out of range. All the noexcept functions may
// be called in the audio thread. Not for two threads at a time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/modal/decay.hpp"
#include "core/modal/mallet.hpp"
#include "core/modal/membrane.hpp"

namespace percussionist::modal {

/// A mallet on its way. The caller sets all but `force`; step() moves it.
struct Striker {
    Mallet mallet;
    double position = 0.0;      ///< of the felt's surface, above the head at rest [m]
    double velocity = 0.0;      ///< upwards [m/s]
    double acceleration = 0.0;  ///< from all but the head, such as gravity and the hand [m/s^2]
    double force = 0.0;         ///< of the head on the striker, during the last sample [N]
};

class StruckMembrane {
  public:
    static constexpr std::size_t kMaxStrikers = 8;

    /// Modes at or above 0.95 of half the sample rate are left out. Throws std::invalid_argument.
    StruckMembrane(const Membrane& membrane, const Decay& decay, std::size_t mode_count,
                   double sample_rate);

    /// Another membrane or decay while it sounds: displacement and velocity of each mode stay, so
    /// that nothing clicks. Throws std::invalid_argument and then changes nothing.
    void tune(const Membrane& membrane, const Decay& decay);

    /// Where striker `i` (below kMaxStrikers) touches the head: r [m], theta [rad].
    void place(std::size_t i, double r, double theta);

    /// One sample: strikers[i] acts at place i. Those beyond kMaxStrikers are left alone.
    void step(std::span<Striker> strikers) noexcept;

    /// The head's displacement at striker i's place [m], as of now.
    double displacement(std::size_t i) const noexcept { return places_[i].displacement; }

    /// phi of every mode at a point: what reads a displacement. Allocates.
    std::vector<double> shapes(double r, double theta) const;
    /// sum weights q: the head's displacement for the weights of shapes() [m].
    double read(std::span<const double> weights) const noexcept;

    /// Of the head: kinetic plus potential [J].
    double energy() const noexcept;
    /// Of head, felts and strikers, without the work of outer accelerations [J].
    double energy(std::span<const Striker> strikers) const noexcept;

    /// The head at rest, at once.
    void rest() noexcept;

    const std::vector<MembraneMode>& modes() const { return modes_; }
    double sample_rate() const { return sample_rate_; }

  private:
    /// A striker's place: phi of every mode there, and the head's displacement with and without
    /// the coming sample's forces.
    struct Place {
        double r = 0.0;
        double theta = 0.0;
        double displacement = 0.0;
        double free_displacement = 0.0;
        std::vector<double> phi;
    };

    void set_coefficients(const Decay& decay);
    void evaluate(Place& place);
    void set_compliances(std::size_t i);
    void swing_freely(std::size_t places) noexcept;
    bool find_forces(std::span<Striker> strikers) noexcept;
    void push(std::span<const Striker> strikers) noexcept;

    double sample_rate_;
    double period_;
    std::vector<MembraneMode> modes_;

    // Each mode's state is q and y = (q' + s q) / wd, wd = sqrt(w^2 - s^2): its free motion turns
    // (q, y) by wd h while shrinking it by exp(-s h). A force f shifts it by f phi (to_q, to_y).
    std::vector<double> q_, y_;
    std::vector<double> turn_cos_, turn_sin_, to_q_, to_y_;
    std::vector<double> loss_, damped_frequency_;  // s [1/s], wd [rad/s]

    std::array<Place, kMaxStrikers> places_;
    // Displacement at place i that a force of 1 N at place j makes within one sample [m/N].
    std::array<std::array<double, kMaxStrikers>, kMaxStrikers> compliance_{};
};

}  // namespace percussionist::modal
