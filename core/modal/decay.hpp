// How long what is struck rings: the loss of each mode.
//
// A mode dies as exp(-s t); its t60, the time to lose 60 dB, is ln(1000) / s. The losses of a head
// grow with frequency, s = s0 + s1 w^2 (s0 of the surrounding air and the hoop, s1 of bending in
// the skin: the form usual for membranes and plates, as in Bilbao, "Numerical Sound Synthesis",
// 2009). The two constants are given outright, or follow from t60 of the lowest mode and t60 at a
// high frequency.
//
// Values only: may be used anywhere.
#pragma once

#include <variant>

namespace percussionist::modal {

struct Decay {
    double t60_low = 1.5;          ///< of the lowest mode [s]; infinite: no loss at all
    double t60_high = 0.15;        ///< at `high_frequency` [s], at most t60_low
    double high_frequency = 2000;  ///< [Hz]
};

struct PhysicalLoss {
    double constant = 4.6;      ///< s0 [1/s]
    double quadratic = 2.6e-7;  ///< s1 [s]
};

using Loss = std::variant<Decay, PhysicalLoss>;

/// Throws std::invalid_argument unless 0 < t60_high <= t60_low (either may be infinite) and
/// high_frequency is finite and above 0; unless s0 and s1 are finite and 0 or more.
void check(const Loss& loss);

/// s [1/s] at the angular frequency w [rad/s] of a body whose lowest is `lowest`. Where the
/// lowest mode is above half of high_frequency, t60_high is taken at twice the lowest.
double loss_at(const Loss& loss, double lowest, double w) noexcept;

/// s [1/s] of a mode that loses 60 dB within t60 [s].
double loss_of_t60(double t60) noexcept;

}  // namespace percussionist::modal
