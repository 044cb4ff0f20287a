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
// Samples are taken in spans (foresight.hpp): in each the modes are moved once. What bodies do to
// each other within a sample is the same for all paces at which it is stepped: where a lossy mallet
// turns around so quickly that one sample does not tell what its felt has taken, this sample is
// made of sixteen shorter ones, and such a one again, by banks of the same modes with shorter
// periods. A reserve of a dozen such samples, filled up by one in 32 samples, bounds what that
// costs.
//
// A membrane that stretches (Membrane::stretch) pulls itself back by one more spring, of elongation
// psi = B sum l q^2, l the integral of |grad phi|^2, with the shape d psi / d q at the middle of
// the sample's free motion: Berger's potential psi^2 / 2 = S / (8 A) (integral of |grad u|^2)^2,
// made quadratic in psi so that it stays passive at any loudness. Its shape being another each
// sample, it is stepped sample by sample, and never at a shorter period.
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

#include "core/modal/foresight.hpp"
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
    /// In the two steps before: where the next is sought from [N].
    std::array<double, 2> forces_before{};
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
    static constexpr int kRefined = 32;  // samples that pay for a refined step
    static constexpr int kFullReserve = 12 * kRefined;

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
    /// All that is another for steps of another length.
    struct Pace {
        Pace(std::size_t modes, double step);

        double period;       ///< [s]
        double flesh_keeps;  ///< of its elongation, a step
        ModeBank bank;
        Foresight sight{kPorts, kPorts + kMaxPickups};
        std::size_t strikers = 0;  ///< foreseen
        Springs springs;
        std::array<Springs::Row, kMaxStrikers> taken{};  ///< of each striker's force, by springs
        bool springs_stale = true;
        bool modes_stale = true;
    };

    void set_modes() noexcept;
    void refresh(bool other_shapes);
    void put(std::size_t port, const Spot& spot);
    void forget(std::size_t port) noexcept;
    void stale_springs() noexcept;
    double stretch_of_modes() const noexcept;

    void land(Pace& pace) noexcept;
    void step_at(std::size_t pace, std::span<Striker> strikers, double force) noexcept;
    bool refine(std::size_t pace, std::span<Striker> strikers, double force) noexcept;
    void read_directly(std::span<const Striker> strikers, double force) noexcept;
    void foresee(Pace& pace, std::size_t strikers) noexcept;
    const Foresight::Course& answer(Pace& pace, std::size_t port, std::size_t output) noexcept;
    double compliance(Pace& pace, std::size_t port, std::size_t other) noexcept {
        return answer(pace, port, other)[0];
    }
    void push_at(Pace& pace, std::size_t port, double force) noexcept;
    void list_springs(const Pace& pace) noexcept;
    void factor_springs(Pace& pace, std::size_t strikers) noexcept;
    void condense(Pace& pace, std::size_t strikers) noexcept;
    bool find_forces(const Pace& pace, std::span<Striker> strikers) noexcept;
    void move(Pace& pace, std::span<Striker> strikers) noexcept;

    double sample_rate_;
    double least_loss_ = 0.0;
    Resonator resonator_;
    std::vector<Pace> paces_;  // the first is the sample's
    std::array<Port, kPorts> ports_;
    std::array<ModeBank::Weights, kMaxPickups> pickups_;
    std::array<double, kMaxPickups> direct_{};  // of a refined sample
    int reserve_;                               // of refined steps, in samples

    // The linear contacts: hands' points, and the tension.
    std::array<Spring, kPorts> spring_{};  // by port
    std::array<std::size_t, Springs::kMost> sprung_{};
    std::size_t sprung_count_ = 0;
    Springs::Row still_{};  // forces, were no striker there
    Values slope_weights_;  // B l of every mode
    bool stretches_ = false;

    // Displacement at one striker that a force of 1 N at another makes within the step, hands and
    // tension answering [m/N].
    std::array<std::array<double, kMaxStrikers>, kMaxStrikers> condensed_{};
};

}  // namespace percussionist::modal
