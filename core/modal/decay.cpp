#include "core/modal/decay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

const double kSixtyDecibels = std::log(1000.0);

}  // namespace

void check(const Decay& decay) {
    if (!(decay.t60_high > 0.0 && decay.t60_high <= decay.t60_low)) {
        throw std::invalid_argument(
            "decay: expected t60 at high frequencies above 0 and at most t60 at low ones [s], "
            "got " +
            std::to_string(decay.t60_low) + " low and " + std::to_string(decay.t60_high) + " high");
    }
    if (!(std::isfinite(decay.high_frequency) && decay.high_frequency > 0.0)) {
        throw std::invalid_argument("decay: expected a high frequency above 0 [Hz], got " +
                                    std::to_string(decay.high_frequency));
    }
}

double loss(const Decay& decay, double lowest, double w) noexcept {
    const double high = std::max(2 * std::numbers::pi * decay.high_frequency, 2 * lowest);
    const double loss_low = kSixtyDecibels / decay.t60_low;
    const double loss_high = kSixtyDecibels / decay.t60_high;
    return loss_low +
           (loss_high - loss_low) * (w * w - lowest * lowest) / (high * high - lowest * lowest);
}

}  // namespace percussionist::modal
