#include "core/modal/mode_bank.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::modal {

namespace {

/// Sums over modes, four to a sample, as the loops leave them.
class Lanes {
  public:
    explicit Lanes(std::span<double> readings)
        : readings_(readings.first(std::min(readings.size(), ModeBank::kChunk))) {
        std::fill_n(sums_, 4 * samples(), 0.0);
    }
    double* sums() { return sums_; }
    std::size_t samples() const { return readings_.size(); }
    void add_up() const {
        for (std::size_t n = 0; n < samples(); ++n) {
            const double* const lane = sums_ + 4 * n;
            readings_[n] = (lane[0] + lane[1]) + (lane[2] + lane[3]);
        }
    }

  private:
    std::span<double> readings_;
    alignas(64) double sums_[4 * ModeBank::kChunk];
};

}  // namespace

ModeBank::ModeBank(std::size_t size, double period, const ModeLoops& loops)
    : loops_(&loops), size_(size), period_(period) {
    const std::size_t whole = (size + kGroup - 1) / kGroup * kGroup;
    modes_.resize(whole);
    damped_.assign(whole, 0.0);
    block_.assign(whole * kSlots, 0.0);
}

Modes ModeBank::moving_modes() const noexcept {
    return {const_cast<double*>(block_.data()), moving_};
}

Modes ModeBank::all_modes() const noexcept {
    return {const_cast<double*>(block_.data()), padded()};
}

void ModeBank::set(std::size_t k, const Mode& mode) noexcept {
    const double velocity = rate(k);
    modes_[k] = mode;
    const double w = mode.angular_frequency;
    const double s = mode.loss;
    if (!(w > 0.0)) {
        damped_[k] = 0.0;
        for (std::size_t row = 0; row < kSlots; ++row) {
            at(static_cast<Slot>(row), k) = 0.0;
        }
        return;
    }
    const double wd = std::sqrt(w * w - s * s);
    const double shrink = std::exp(-s * period_);
    const double c = shrink * std::cos(wd * period_);
    const double d = shrink * std::sin(wd * period_);
    // 1 - c, without cancellation.
    const double half_sine = std::sin(0.5 * wd * period_);
    const double missing = -std::expm1(-s * period_) + shrink * 2 * half_sine * half_sine;
    const double give = 1.0 / (mode.mass * w * w);
    damped_[k] = wd;
    at(kY, k) = (velocity + s * at(kQ, k)) / wd;
    at(kCos, k) = c;
    at(kSin, k) = d;
    at(kToQ, k) = give * (missing - d * s / wd);
    at(kToY, k) = give * (d + missing * s / wd);
    double many_c = c, many_d = d;
    for (std::size_t n = 1; n < kChunk;) {
        const double square = many_c * many_c - many_d * many_d;
        many_d = 2 * many_c * many_d;
        many_c = square;
        n *= 2;
        if (n == kSpan) {
            at(kSpanCos, k) = many_c;
            at(kSpanSin, k) = many_d;
        }
    }
    at(kChunkCos, k) = many_c;
    at(kChunkSin, k) = many_d;
}

void ModeBank::continue_from(const ModeBank& other, long shift) noexcept {
    for (std::size_t k = 0; k < size_; ++k) {
        const long there = static_cast<long>(k) + shift;
        if (damped_[k] > 0.0 && there >= 0 && there < static_cast<long>(other.size_)) {
            const auto from = static_cast<std::size_t>(there);
            at(kQ, k) = other.at(kQ, from);
            at(kY, k) = (other.rate(from) + modes_[k].loss * at(kQ, k)) / damped_[k];
        }
    }
    moving_ = padded();
}

void ModeBank::take_motion(const ModeBank& other) noexcept {
    moving_ = std::min(other.moving_, padded());
    for (std::size_t k = 0; k < padded(); ++k) {
        at(kQ, k) = k < moving_ ? other.at(kQ, k) : 0.0;
        at(kY, k) = k < moving_ ? other.at(kY, k) : 0.0;
    }
}

void ModeBank::advance(std::size_t samples) noexcept {
    if (samples == kChunk) {
        loops_->turn_by(moving_modes(), kChunkCos);
    } else if (samples == kSpan) {
        loops_->turn_by(moving_modes(), kSpanCos);
    } else {
        loops_->turn(moving_modes(), std::min(samples, kChunk));
    }
}

void ModeBank::give(std::span<const double> forces, std::span<const double> phi) noexcept {
    moving_ = padded();
    if (forces.size() == 1) {
        loops_->give_once(all_modes(), forces[0], phi.data());
    } else {
        loops_->give(all_modes(), forces.data(), forces.size(), phi.data());
    }
}

double ModeBank::swing_about(std::span<const double> weights, std::span<double> middle) noexcept {
    moving_ = padded();  // all of `middle` is to be filled
    return loops_->swing_about(moving_modes(), weights.data(), middle.data());
}

double ModeBank::direct(const Weights& weights, std::span<const double> phi) noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < weights.force.size(); ++k) {
        sum += weights.force[k] * phi[k];
    }
    return sum;
}

double ModeBank::displacement(std::span<const double> phi) const noexcept {
    return loops_->sum(moving_modes(), phi.data());
}

double ModeBank::reading(const Weights& weights) const noexcept {
    return loops_->read(moving_modes(), weights.q.data(), weights.y.data());
}

double ModeBank::square_sum(std::span<const double> weights) const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < std::min(size_, moving_); ++k) {
        sum += weights[k] * at(kQ, k) * at(kQ, k);
    }
    return sum;
}

void ModeBank::read_velocity(std::span<const double> phi, Weights& weights) const noexcept {
    for (std::size_t k = 0; k < padded(); ++k) {
        weights.q[k] = -modes_[k].loss * phi[k];
        weights.y[k] = damped_[k] * phi[k];
    }
}

void ModeBank::read_acceleration(std::span<const double> in_phase, std::span<const double> later,
                                 Weights& weights) const noexcept {
    for (std::size_t k = 0; k < padded(); ++k) {
        const double s = modes_[k].loss;
        const double w = modes_[k].angular_frequency;
        const double of_q = 2 * s * s - w * w;
        const double of_y = -2 * s * damped_[k];
        // A quarter of a period ago (q, y) was (-y, q).
        weights.q[k] = in_phase[k] * of_q + later[k] * of_y;
        weights.y[k] = in_phase[k] * of_y - later[k] * of_q;
        weights.force[k] = in_phase[k] / modes_[k].mass;
    }
}

void ModeBank::ring(const Weights& weights, std::span<double> readings) const noexcept {
    Lanes lanes(readings);
    loops_->ring(moving_modes(), weights.q.data(), weights.y.data(), lanes.sums(), lanes.samples());
    lanes.add_up();
}

void ModeBank::ring(std::span<const double> phi, std::span<double> displacements) const noexcept {
    Lanes lanes(displacements);
    loops_->ring(moving_modes(), phi.data(), nullptr, lanes.sums(), lanes.samples());
    lanes.add_up();
}

void ModeBank::answer(std::span<const double> phi, const Weights& weights,
                      std::span<double> readings) const noexcept {
    answer(phi.data(), weights.q.data(), weights.y.data(), readings);
    readings[0] += direct(weights, phi);
}

void ModeBank::answer(std::span<const double> phi, std::span<const double> other,
                      std::span<double> displacements) const noexcept {
    answer(phi.data(), other.data(), nullptr, displacements);
}

void ModeBank::answer(const double* phi, const double* a, const double* b,
                      std::span<double> readings) const noexcept {
    if (readings.size() == 1) {
        readings[0] = loops_->respond_once(all_modes(), phi, a, b);
        return;
    }
    Lanes lanes(readings);
    loops_->respond(all_modes(), phi, a, b, lanes.sums(), lanes.samples());
    lanes.add_up();
}

double ModeBank::mode_energy(std::size_t k) const noexcept {
    const double w = modes_[k].angular_frequency;
    const double swing = w * at(kQ, k);
    return 0.5 * modes_[k].mass * (rate(k) * rate(k) + swing * swing);
}

double ModeBank::energy() const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < std::min(size_, moving_); ++k) {
        sum += mode_energy(k);
    }
    return sum;
}

void ModeBank::rest() noexcept {
    for (std::size_t k = 0; k < moving_; ++k) {
        at(kQ, k) = at(kY, k) = 0.0;
    }
    moving_ = 0;
}

void ModeBank::retire(double energy) noexcept {
    std::size_t last = 0;
    for (std::size_t k = 0; k < std::min(size_, moving_); ++k) {
        if (mode_energy(k) < energy) {
            at(kQ, k) = at(kY, k) = 0.0;
        } else {
            last = k + 1;
        }
    }
    moving_ = (last + kGroup - 1) / kGroup * kGroup;
}

}  // namespace percussionist::modal
