// A head, or another body, that is touched: a bank of modes, the felts that press on it and the
// hands that lie on it, solved together at every sample.
//
// During a sample each contact's force f is constant, and everything moves exactly as it then must:
//     the modes             q'' + 2 s q' + w^2 q = -f phi(point) / m      (a turn and a shift)
//     the striker           z'' = acceleration + f / mass                 (a parabola)
// The force's work is therefore exact on both sides, and with the laws of mallet.hpp and
// springs.hpp the energy of head, felts, hands and strikers stays the same to rounding when nothing
// is lossy, and never grows when something is. The turn is of length below 1 for whatever frequency
// and loss: no setting, nor its change while the head swings, can make it unstable. The same phi
// shares the force out and reads the displacement back, so that what A feels of B is what B feels
// of A.
//
// A membrane that stretches (Membrane::stretch) pulls itself back by one more spring, of elongation
// psi = B sum l q^2, l the integral of |grad phi|^2, with the shape d psi / d q at the middle of
// the sample's free motion: Berger's potential psi^2 / 2 = S / (8 A) (integral of |grad u|^2)^2,
// made quadratic in psi so that it stays passive at any loudness.
//
// Frame: along the head's normal, z > 0 above the head on the striker's side, the head at rest at
// 0. A striker touches where z is below the head's displacement at its place. Beyond the rim the
// head does not move: there a striker meets a rigid wall.
//
// The constructor, become() and shapes() allocate. All else may be called in the audio thread, not
// by two threads at a time. place() and lay() take some 5 microseconds a hundred modes.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/modal/hand.hpp"
#include "core/modal/mallet.hpp"
#include "core/modal/mode_bank.hpp"
#include "core/modal/resonator.hpp"
#include "core/modal/springs.hpp"

namespace percussionist::modal {

/// A mallet on its way. The caller sets all but `force`; step() moves it. With a mass of kDriven
/// nothing the head does moves it: it goes where its velocity takes it.
struct Striker {
    Mallet mallet{};
    double position = 0.0;      ///< of the felt's surface, above the head at rest [m]
    double velocity = 0.0;      ///< upwards [m/s]
    double acceleration = 0.0;  ///< from all but the head, such as gravity and the hand [m/s^2]
    double force = 0.0;         ///< of the head on the striker, during the last sample [N]
    bool stuck = false;         ///< to a sticky head
    double force_before = 0.0;  ///< in the sample before: where the next is sought from [N]
};

constexpr double kDriven = std::numeric_limits<double>::infinity();

class StruckHead {
  public:
    static constexpr std::size_t kMaxStrikers = 8;
    static constexpr std::size_t kMaxHands = 4;
    static constexpr std::size_t kMaxPickups = 8;

    /// Modes at or above 0.95 of half the sample rate stay silent. Throws std::invalid_argument.
    StruckHead(Resonator resonator, double sample_rate);

    /// Another body of the same kind while it sounds, see Resonator::retune(): displacement and
    /// velocity of each mode stay, so that nothing clicks. Throws std::invalid_argument and then
    /// changes nothing.
    bool retune(const Body& body, const Loss& loss);
    /// Any other body: its mode k takes over from mode k + first (where there is one). What is to
    /// be heard has to be told anew, see listen().
    void become(Resonator resonator, long first);

    /// Where striker `i` (below kMaxStrikers) touches the head: r [m], theta [rad]. Also to be
    /// called for one that had no part in the steps before.
    void place(std::size_t i, double r, double theta);
    /// Where the force of step() acts.
    void place_force(double r, double theta);
    /// Hand i (below kMaxHands) comes to lie, moves, presses otherwise; without pressure it is
    /// gone. What its flesh has stored does not grow by that. Throws std::invalid_argument.
    void lay(std::size_t i, const Hand& hand);

    /// What reading(i) reads: weights of bank().
    void listen(std::size_t i, const ModeBank::Weights& weights);

    /// One sample: strikers[i] acts at place i, and a force [N], positive upwards, at its place.
    /// Those beyond kMaxStrikers are left alone.
    void step(std::span<Striker> strikers, double force = 0.0) noexcept;
    /// The head's displacement at striker i's place [m], as of now.
    double displacement(std::size_t i) const noexcept { return ports_[i].displacement; }
    double reading(std::size_t i) const noexcept;

    /// Every mode loses at least so much [1/s], until told otherwise.
    void damp(double least_loss) noexcept;
    /// After the bank has been moved other than by step().
    void settle() noexcept;

    bool stretches() const noexcept { return stretches_; }
    /// Whether steps without strikers do more than let each mode ring by itself: a hand lies on
    /// the head, or it swings so wide that its pitch is off by more than a hundredth of a cent.
    bool coupled() const noexcept;

    /// phi of every mode at a point, as bank() takes it. Allocates.
    Values shapes(double r, double theta) const;

    /// The modes' motion: to read the head elsewhere, or to let it ring without contacts.
    ModeBank& bank() noexcept;
    const ModeBank& bank() const noexcept { return const_cast<StruckHead*>(this)->bank(); }

    /// Of head, felts, hands and strikers, without the work of outer accelerations [J].
    double energy(std::span<const Striker> strikers) const noexcept;

    void rest() noexcept;                                  ///< the head, at once
    void exchange(std::size_t i, std::size_t j) noexcept;  ///< strikers i and j change numbers

    const Resonator& resonator() const { return resonator_; }
    std::span<const RoundMode> modes() const { return resonator_.round(); }
    double sample_rate() const { return sample_rate_; }

  private:
    static constexpr std::size_t kHandPorts = kMaxStrikers;
    static constexpr std::size_t kTension = kHandPorts + kMaxHands * HandPoints::kMost;
    static constexpr std::size_t kForce = kTension + 1;
    static constexpr std::size_t kPorts = kForce + 1;

    /// Where something acts on the head: phi of every mode, and the head's displacement with and
    /// without the coming sample's forces.
    struct Port {
        Spot spot;
        double displacement = 0.0;
        double free = 0.0;
        double rate = 0.0;  ///< mean velocity in the last sample
        bool used = false;
        Values phi;
    };
    struct Pickup {
        ModeBank::Weights weights;
        std::array<double, kPorts> response{};  ///< to 1 N at a port during one sample
    };
    /// Of the first pickup, already read while the bank swung.
    struct EarlyReading {
        double value = 0.0;
        bool there = false;
    };

    void set_bank() noexcept;
    void refresh(bool other_shapes);
    void put(std::size_t port, const Spot& spot);
    void couple(std::size_t port) noexcept;
    void apply_pushes() noexcept;
    void swing_freely(std::size_t strikers, double force) noexcept;
    void list_springs() noexcept;
    void condense(std::size_t strikers) noexcept;
    void find_forces(std::span<Striker> strikers) noexcept;
    void answer(std::span<Striker> strikers) noexcept;
    void push_at(std::size_t port, double force) noexcept;
    double stretch_of_modes() const noexcept;

    double sample_rate_;
    double period_;
    double least_loss_ = 0.0;
    Resonator resonator_;
    ModeBank bank_;
    std::array<Port, kPorts> ports_;
    // Displacement at one port that a force of 1 N at another makes within one sample [m/N].
    std::array<std::array<double, kPorts>, kPorts> compliance_{};
    std::array<Pickup, kMaxPickups> pickups_;
    EarlyReading early_;

    // The linear contacts: hands' points, and the tension.
    std::array<Spring, kPorts> spring_{};  // by port
    std::array<std::size_t, Springs::kMost> sprung_{};
    std::size_t sprung_count_ = 0;
    Springs springs_;
    Springs::Row still_{};                            // forces, were no striker there
    std::array<Springs::Row, kMaxStrikers> taken_{};  // of each striker's force, by springs
    std::array<std::array<double, kMaxStrikers>, kMaxStrikers> condensed_{};
    bool springs_stale_ = true;
    Values slope_weights_;  // B l of every mode
    bool stretches_ = false;

    // Forces of the last sample, not yet given to the bank.
    std::array<ModeBank::Push, kPorts> pushes_{};
    std::array<std::size_t, kPorts> pushed_{};
    std::size_t push_count_ = 0;
};

}  // namespace percussionist::modal
