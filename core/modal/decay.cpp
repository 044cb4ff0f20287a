#include "core/modal/decay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

void check_decay(const Decay& decay) {
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

void check_physical(const PhysicalLoss& loss) {
    for (const double value : {loss.constant, loss.quadratic}) {
        if (!(std::isfinite(value) && value >= 0.0)) {
            throw std::invalid_argument("losses: expected numbers of 0 or more [1/s] [s], got " +
                                        std::to_string(value));
        }
    }
}

double of_decay(const Decay& decay, double lowest, double w) noexcept {
    const double high = std::max(2 * std::numbers::pi * decay.high_frequency, 2 * lowest);
    const double loss_low = loss_of_t60(decay.t60_low);
    const double loss_high = loss_of_t60(decay.t60_high);
    return loss_low +
           (loss_high - loss_low) * (w * w - lowest * lowest) / (high * high - lowest * lowest);
}

}  // namespace

double loss_of_t60(double t60) noexcept {
    static const double kSixtyDecibels = std::log(1000.0);
    return kSixtyDecibels / t60;
}

void check(const Loss& loss) {
    if (const auto* decay = std::get_if<Decay>(&loss)) {
        check_decay(*decay);
    } else {
        check_physical(*std::get_if<PhysicalLoss>(&loss));
    }
}

double loss_at(const Loss& loss, double lowest, double w) noexcept {
    if (const auto* physical = std::get_if<PhysicalLoss>(&loss)) {
        return physical->constant + physical->quadratic * w * w;
    }
    return of_decay(*std::get_if<Decay>(&loss), lowest, w);
}

}  // namespace percussionist::modal
