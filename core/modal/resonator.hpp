// What rings, apart from how it moves: its modes, and where they move how much.
//
// A membrane, a free plate, or modes given outright; of all its modes those from `skip` on sound,
// at most `count`. The constructors allocate and take some milliseconds for thousands of modes;
// retune() and the shapes do not.
#pragma once

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

#include "core/modal/decay.hpp"
#include "core/modal/given_modes.hpp"
#include "core/modal/membrane.hpp"
#include "core/modal/mode_bank.hpp"
#include "core/modal/plate.hpp"

namespace percussionist::modal {

using Body = std::variant<Membrane, Plate, GivenModes>;

/// Which modes, lowest first.
struct Choice {
    std::size_t count = 240;  ///< at most; 1 to kMostModes
    std::size_t skip = 0;     ///< of the lowest
};

class Resonator {
  public:
    /// Throws std::invalid_argument for what cannot be.
    Resonator(const Body& body, const Loss& loss, const Choice& choice);

    /// The same modes, of a body of the same kind (a plate also of the same `poisson`), or none of
    /// it happens: false. Does not allocate, but for given modes, which have their own losses.
    bool retune(const Body& body, const Loss& loss);

    std::size_t size() const { return oscillators_.size(); }
    const Body& body() const { return body_; }
    double radius() const;
    /// Frequency without losses, losses, modal mass.
    const ModeBank::Mode& mode(std::size_t k) const { return oscillators_[k]; }
    std::span<const ModeBank::Mode> oscillators() const { return oscillators_; }
    /// Round bodies' modes; empty if they were given.
    std::span<const RoundMode> round() const;

    /// phi of every mode at a spot. `values` has room.
    void shapes(const Spot& spot, std::span<double> values) const noexcept;
    /// Integral of |grad phi|^2 of mode k; 0 but for membranes.
    double slope(std::size_t k) const noexcept;

  private:
    void set_oscillators(const Loss& loss);

    Body body_;
    Choice choice_;
    std::vector<RoundMode> round_;  // from the lowest, those skipped too
    std::vector<ModeBank::Mode> oscillators_;
};

/// Modes from `low` to `high` [Hz] of a body; those it has no room for are left out at the top.
/// Throws std::invalid_argument if there are none.
Choice band(const Body& body, double low, double high);

}  // namespace percussionist::modal
