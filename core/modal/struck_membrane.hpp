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
// The constructor and shapes() allocate. place() and tune() do not, unless they throw; they take
// some 20 microseconds for 120 modes (tune() with another radius eight times that). All else is
// noexcept and may be called in the audio thread. Not for two threads at a time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/modal/decay.hpp"
#include "core/modal/mallet.hpp"
#include "core/modal/membrane.hpp"
#include "core/modal/mode_bank.hpp"

namespace percussionist::modal {

/// A mallet on its way. The caller sets all but `force`; step() moves it.
struct Striker {
    Mallet mallet{};
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

    /// Where striker `i` (below kMaxStrikers) touches the head: r [m], theta [rad]. Also to be
    /// called for one that had no part in the steps before.
    void place(std::size_t i, double r, double theta);

    /// One sample: strikers[i] acts at place i. Those beyond kMaxStrikers are left alone.
    void step(std::span<Striker> strikers) noexcept;

    /// The head's displacement at striker i's place [m], as of now.
    double displacement(std::size_t i) const noexcept { return places_[i].displacement; }

    /// phi of every mode at a point, as bank() takes it. Allocates.
    std::vector<double> shapes(double r, double theta) const;

    /// The modes' motion: to read the head elsewhere, or to let it ring without strikers.
    ModeBank& bank() { return bank_; }
    const ModeBank& bank() const { return bank_; }

    /// Of head, felts and strikers, without the work of outer accelerations [J].
    double energy(std::span<const Striker> strikers) const noexcept;

    /// The head at rest, at once.
    void rest() noexcept;
    /// Brings the head to where another is, mode by mode; the strikers' places stay.
    void continue_from(const StruckMembrane& other) noexcept;
    /// Strikers i and j change numbers.
    void exchange(std::size_t i, std::size_t j) noexcept;

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

    void set_modes(const Decay& decay);
    void evaluate(Place& place);
    void set_compliances(std::size_t i);
    bool find_forces(std::span<Striker> strikers) noexcept;

    double sample_rate_;
    double period_;
    std::vector<MembraneMode> modes_;
    ModeBank bank_;
    std::array<Place, kMaxStrikers> places_;
    // Displacement at place i that a force of 1 N at place j makes within one sample [m/N].
    std::array<std::array<double, kMaxStrikers>, kMaxStrikers> compliance_{};
};

}  // namespace percussionist::modal
