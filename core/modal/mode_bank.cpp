#include "core/modal/mode_bank.hpp"

#include <algorithm>
#include <array>
#include <cmath>

// The inner loops once more for processors with AVX2, chosen when the library is loaded. Not under
// sanitizers, whose run-time is not ready by then.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PERCUSSIONIST_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define PERCUSSIONIST_CLONES
#endif

namespace percussionist::modal {

namespace {

/// Four modes at once; in twos where the processor has no more.
using Lanes __attribute__((vector_size(32), aligned(8), may_alias)) = double;
constexpr std::size_t kLanes = 4;

Lanes& lanes(double* values) {
    return *reinterpret_cast<Lanes*>(values);
}

const Lanes& lanes(const double* values) {
    return *reinterpret_cast<const Lanes*>(values);
}

double sum_of(const Lanes& lanes) {
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/// The bank as the loops see it.
struct Turn {
    double* q;
    double* y;
    const double* c;
    const double* s;
    std::size_t size;
};

/// Sums in the order of weighted_sum().
PERCUSSIONIST_CLONES
double turn_all(const Turn& bank, const double* weights) {
    Lanes even{}, odd{};
    for (std::size_t k = 0; k < bank.size; k += 2 * kLanes) {
        const Lanes q0 = lanes(bank.q + k), q1 = lanes(bank.q + k + kLanes);
        const Lanes y0 = lanes(bank.y + k), y1 = lanes(bank.y + k + kLanes);
        const Lanes c0 = lanes(bank.c + k), c1 = lanes(bank.c + k + kLanes);
        const Lanes s0 = lanes(bank.s + k), s1 = lanes(bank.s + k + kLanes);
        const Lanes t0 = c0 * q0 + s0 * y0, t1 = c1 * q1 + s1 * y1;
        lanes(bank.q + k) = t0;
        lanes(bank.q + k + kLanes) = t1;
        lanes(bank.y + k) = c0 * y0 - s0 * q0;
        lanes(bank.y + k + kLanes) = c1 * y1 - s1 * q1;
        even += lanes(weights + k) * t0;
        odd += lanes(weights + k + kLanes) * t1;
    }
    return sum_of(even + odd);
}

PERCUSSIONIST_CLONES
double weighted_sum(const double* weights, const double* values, std::size_t size) {
    Lanes even{}, odd{};
    for (std::size_t k = 0; k < size; k += 2 * kLanes) {
        even += lanes(weights + k) * lanes(values + k);
        odd += lanes(weights + k + kLanes) * lanes(values + k + kLanes);
    }
    return sum_of(even + odd);
}

PERCUSSIONIST_CLONES
void push_all(double* q, double* y, const double* to_q, const double* to_y, const double* phi,
              double force, std::size_t size) {
    for (std::size_t k = 0; k < size; k += kLanes) {
        const Lanes share = force * lanes(phi + k);
        lanes(q + k) += lanes(to_q + k) * share;
        lanes(y + k) += lanes(to_y + k) * share;
    }
}

/// In the order in which ring_all() sums.
PERCUSSIONIST_CLONES
double weighted_sum(const Turn& bank, const double* weights_q, const double* weights_y) {
    Lanes sum{};
    for (std::size_t k = 0; k < bank.size; k += 2 * kLanes) {
        sum +=
            (lanes(weights_q + k) * lanes(bank.q + k) + lanes(weights_y + k) * lanes(bank.y + k)) +
            (lanes(weights_q + k + kLanes) * lanes(bank.q + k + kLanes) +
             lanes(weights_y + k + kLanes) * lanes(bank.y + k + kLanes));
    }
    return sum_of(sum);
}

/// A group stays in registers for all samples; each sample's sum waits in memory.
PERCUSSIONIST_CLONES
void ring_all(const Turn& bank, const double* weights_q, const double* weights_y, double* sums,
              std::size_t samples) {
    for (std::size_t k = 0; k < bank.size; k += 2 * kLanes) {
        Lanes q0 = lanes(bank.q + k), q1 = lanes(bank.q + k + kLanes);
        Lanes y0 = lanes(bank.y + k), y1 = lanes(bank.y + k + kLanes);
        const Lanes c0 = lanes(bank.c + k);
        const Lanes c1 = lanes(bank.c + k + kLanes);
        const Lanes s0 = lanes(bank.s + k);
        const Lanes s1 = lanes(bank.s + k + kLanes);
        const Lanes a0 = lanes(weights_q + k);
        const Lanes a1 = lanes(weights_q + k + kLanes);
        const Lanes b0 = lanes(weights_y + k);
        const Lanes b1 = lanes(weights_y + k + kLanes);
        for (std::size_t i = 0; i < samples; ++i) {
            const Lanes t0 = c0 * q0 + s0 * y0;
            const Lanes t1 = c1 * q1 + s1 * y1;
            y0 = c0 * y0 - s0 * q0;
            y1 = c1 * y1 - s1 * q1;
            q0 = t0;
            q1 = t1;
            lanes(sums + kLanes * i) += (a0 * q0 + b0 * y0) + (a1 * q1 + b1 * y1);
        }
        lanes(bank.q + k) = q0;
        lanes(bank.q + k + kLanes) = q1;
        lanes(bank.y + k) = y0;
        lanes(bank.y + k + kLanes) = y1;
    }
}

}  // namespace

ModeBank::ModeBank(std::size_t size, double period) : size_(size), period_(period) {
    const std::size_t whole = (size + kGroup - 1) / kGroup * kGroup;
    modes_.resize(whole);
    for (auto* values : {&damped_, &q_, &y_, &cos_, &sin_, &to_q_, &to_y_}) {
        values->assign(whole, 0.0);
    }
}

void ModeBank::set(std::size_t k, const Mode& mode) noexcept {
    const double velocity = rate(k);
    modes_[k] = mode;
    const double w = mode.angular_frequency;
    const double s = mode.loss;
    if (!(w > 0.0)) {
        damped_[k] = q_[k] = y_[k] = cos_[k] = sin_[k] = to_q_[k] = to_y_[k] = 0.0;
        return;
    }
    const double wd = std::sqrt(w * w - s * s);
    const double shrink = std::exp(-s * period_);
    damped_[k] = wd;
    y_[k] = (velocity + s * q_[k]) / wd;
    cos_[k] = shrink * std::cos(wd * period_);
    sin_[k] = shrink * std::sin(wd * period_);
    // 1 - cos_, without cancellation.
    const double half_sine = std::sin(0.5 * wd * period_);
    const double missing = -std::expm1(-s * period_) + shrink * 2 * half_sine * half_sine;
    const double give = 1.0 / (mode.mass * w * w);
    to_q_[k] = give * (missing - sin_[k] * s / wd);
    to_y_[k] = give * (sin_[k] + missing * s / wd);
}

void ModeBank::continue_from(const ModeBank& other) noexcept {
    for (std::size_t k = 0; k < std::min(size_, other.size_); ++k) {
        if (damped_[k] > 0.0) {
            q_[k] = other.q_[k];
            y_[k] = (other.rate(k) + modes_[k].loss * q_[k]) / damped_[k];
        }
    }
}

double ModeBank::swing(std::span<const double> phi) noexcept {
    return turn_all({q_.data(), y_.data(), cos_.data(), sin_.data(), q_.size()}, phi.data());
}

void ModeBank::push(double force, std::span<const double> phi) noexcept {
    push_all(q_.data(), y_.data(), to_q_.data(), to_y_.data(), phi.data(), force, q_.size());
}

double ModeBank::compliance(std::span<const double> phi,
                            std::span<const double> other) const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < size_; ++k) {
        sum += phi[k] * other[k] * to_q_[k];
    }
    return sum;
}

double ModeBank::displacement(std::span<const double> phi) const noexcept {
    return weighted_sum(phi.data(), q_.data(), q_.size());
}

void ModeBank::set_weights(std::span<const double> phi, VelocityWeights& weights) const noexcept {
    for (std::size_t k = 0; k < q_.size(); ++k) {
        weights.q[k] = -modes_[k].loss * phi[k];
        weights.y[k] = damped_[k] * phi[k];
    }
}

double ModeBank::velocity(const VelocityWeights& weights) const noexcept {
    auto* const self = const_cast<ModeBank*>(this);  // only read
    return weighted_sum({self->q_.data(), self->y_.data(), nullptr, nullptr, q_.size()},
                        weights.q.data(), weights.y.data());
}

void ModeBank::ring(const VelocityWeights& weights, std::span<double> velocities) noexcept {
    std::array<double, kMostAtOnce * kLanes> sums{};
    const std::size_t samples = std::min(velocities.size(), kMostAtOnce);
    ring_all({q_.data(), y_.data(), cos_.data(), sin_.data(), q_.size()}, weights.q.data(),
             weights.y.data(), sums.data(), samples);
    for (std::size_t i = 0; i < samples; ++i) {
        velocities[i] = sum_of(lanes(sums.data() + kLanes * i));
    }
}

double ModeBank::energy() const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < size_; ++k) {
        const double w = modes_[k].angular_frequency;
        sum += 0.5 * modes_[k].mass * (rate(k) * rate(k) + w * w * q_[k] * q_[k]);
    }
    return sum;
}

void ModeBank::rest() noexcept {
    std::fill(q_.begin(), q_.end(), 0.0);
    std::fill(y_.begin(), y_.end(), 0.0);
}

void ModeBank::rest_the_faint() noexcept {
    constexpr double kFaint = 1e-100;
    for (std::size_t k = 0; k < size_; ++k) {
        if (std::abs(q_[k]) < kFaint && std::abs(y_[k]) < kFaint) {
            q_[k] = y_[k] = 0.0;
        }
    }
}

}  // namespace percussionist::modal
