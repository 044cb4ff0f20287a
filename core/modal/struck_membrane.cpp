#include "core/modal/struck_membrane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

/// Modes closer to half the sample rate than this would only alias.
constexpr double kBand = 0.95;
/// A mode is kept an oscillation however large its loss: s at most this part of w.
constexpr double kGreatestDamping = 0.9;
/// Coordinate descent on a convex function: it always converges; this many sweeps are never needed.
constexpr int kMostSweeps = 50;

}  // namespace

StruckMembrane::StruckMembrane(const Membrane& membrane, const Decay& decay, std::size_t mode_count,
                               double sample_rate)
    : sample_rate_(sample_rate), period_(1.0 / sample_rate) {
    if (!(std::isfinite(sample_rate) && sample_rate > 0.0)) {
        throw std::invalid_argument("struck membrane: expected a sample rate above 0 [Hz], got " +
                                    std::to_string(sample_rate));
    }
    check(decay);
    modes_ = membrane_modes(membrane, mode_count);
    for (auto* values :
         {&q_, &y_, &turn_cos_, &turn_sin_, &to_q_, &to_y_, &loss_, &damped_frequency_}) {
        values->assign(mode_count, 0.0);
    }
    set_coefficients(decay);
    for (std::size_t i = 0; i < kMaxStrikers; ++i) {
        places_[i].phi.assign(mode_count, 0.0);
        place(i, 0.0, 0.0);
    }
}

void StruckMembrane::tune(const Membrane& membrane, const Decay& decay) {
    check(decay);
    const double radius_before = modes_.empty() ? membrane.radius : modes_[0].radius;
    retune(modes_, membrane);
    // y is made of q and q', which stay.
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        y_[k] = damped_frequency_[k] * y_[k] - loss_[k] * q_[k];
    }
    set_coefficients(decay);
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        y_[k] = (y_[k] + loss_[k] * q_[k]) / damped_frequency_[k];
    }
    for (auto& place : places_) {
        if (membrane.radius != radius_before) {
            evaluate(place);
        }
    }
    for (std::size_t i = 0; i < kMaxStrikers; ++i) {
        set_compliances(i);
    }
}

void StruckMembrane::set_coefficients(const Decay& decay) {
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        const double w = modes_[k].angular_frequency;
        const double s =
            std::min(loss(decay, modes_[0].angular_frequency, w), kGreatestDamping * w);
        const double wd = std::sqrt(w * w - s * s);
        loss_[k] = s;
        damped_frequency_[k] = wd;
        const double shrink = std::exp(-s * period_);
        turn_cos_[k] = shrink * std::cos(wd * period_);
        turn_sin_[k] = shrink * std::sin(wd * period_);
        // The motion towards the new rest position q = f phi / (m w^2), without cancellation.
        const double half_sine = std::sin(0.5 * wd * period_);
        const double missing = -std::expm1(-s * period_) + shrink * 2 * half_sine * half_sine;
        const double give = 1.0 / (modes_[k].modal_mass * w * w);
        to_q_[k] = give * (missing - turn_sin_[k] * s / wd);
        to_y_[k] = give * (turn_sin_[k] + missing * s / wd);
        if (!(w * period_ < kBand * std::numbers::pi)) {
            q_[k] = y_[k] = turn_cos_[k] = turn_sin_[k] = to_q_[k] = to_y_[k] = 0.0;
        }
    }
}

void StruckMembrane::place(std::size_t i, double r, double theta) {
    if (i >= kMaxStrikers || !(std::isfinite(r) && r >= 0.0 && std::isfinite(theta))) {
        throw std::invalid_argument(
            "struck membrane: expected a place of r 0 or more [m] and theta [rad], got " +
            std::to_string(r) + " and " + std::to_string(theta));
    }
    places_[i].r = r;
    places_[i].theta = theta;
    evaluate(places_[i]);
    set_compliances(i);
}

void StruckMembrane::evaluate(Place& place) {
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        place.phi[k] = modes_[k].shape(place.r, place.theta);
    }
    place.displacement = read(place.phi);
}

void StruckMembrane::set_compliances(std::size_t i) {
    for (std::size_t j = 0; j < kMaxStrikers; ++j) {
        double sum = 0.0;
        if (!places_[j].phi.empty()) {
            for (std::size_t k = 0; k < modes_.size(); ++k) {
                sum += places_[i].phi[k] * places_[j].phi[k] * to_q_[k];
            }
        }
        compliance_[i][j] = compliance_[j][i] = sum;
    }
}

void StruckMembrane::step(std::span<Striker> strikers) noexcept {
    const auto acting = strikers.first(std::min(strikers.size(), kMaxStrikers));
    swing_freely(acting.size());
    const bool touched = find_forces(acting);
    for (auto& striker : acting) {
        const double acceleration = striker.acceleration + striker.force / striker.mallet.mass;
        striker.position += period_ * (striker.velocity + 0.5 * period_ * acceleration);
        striker.velocity += period_ * acceleration;
    }
    if (touched) {
        push(acting);
    }
    for (std::size_t i = 0; i < acting.size(); ++i) {
        double displacement = places_[i].free_displacement;
        for (std::size_t j = 0; touched && j < acting.size(); ++j) {
            displacement -= compliance_[i][j] * acting[j].force;
        }
        places_[i].displacement = displacement;
    }
}

void StruckMembrane::swing_freely(std::size_t places) noexcept {
    const std::size_t n = q_.size();
    double* const q = q_.data();
    double* const y = y_.data();
    const double* const c = turn_cos_.data();
    const double* const s = turn_sin_.data();
    for (std::size_t k = 0; k < n; ++k) {
        const double turned = c[k] * q[k] + s[k] * y[k];
        y[k] = c[k] * y[k] - s[k] * q[k];
        q[k] = turned;
    }
    for (std::size_t i = 0; i < places; ++i) {
        places_[i].free_displacement = read(places_[i].phi);
    }
}

bool StruckMembrane::find_forces(std::span<Striker> strikers) noexcept {
    const std::size_t n = strikers.size();
    bool touched = false;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double change = 0.0;
        double greatest = 0.0;
        touched = false;
        for (std::size_t i = 0; i < n; ++i) {
            Striker& striker = strikers[i];
            const Place& place = places_[i];
            double head = place.free_displacement - place.displacement;
            for (std::size_t j = 0; j < n; ++j) {
                head -= j == i ? 0.0 : compliance_[i][j] * strikers[j].force;
            }
            const double half_square = 0.5 * period_ * period_;
            const ContactStep contact{
                .compression = place.displacement - striker.position,
                .free_change =
                    head - period_ * striker.velocity - half_square * striker.acceleration,
                .compliance = compliance_[i][i] + half_square / striker.mallet.mass,
                .duration = period_};
            const double force = contact_force(striker.mallet, contact, striker.force);
            change = std::max(change, std::abs(force - striker.force));
            greatest = std::max(greatest, force);
            touched = touched || force > 0.0;
            striker.force = force;
        }
        if (n == 1 || change <= 1e-14 * greatest) {
            break;
        }
    }
    return touched;
}

void StruckMembrane::push(std::span<const Striker> strikers) noexcept {
    const std::size_t n = q_.size();
    for (std::size_t i = 0; i < strikers.size(); ++i) {
        const double force = strikers[i].force;
        if (force == 0.0) {
            continue;
        }
        const double* const phi = places_[i].phi.data();
        for (std::size_t k = 0; k < n; ++k) {
            const double share = force * phi[k];
            q_[k] -= to_q_[k] * share;
            y_[k] -= to_y_[k] * share;
        }
    }
}

std::vector<double> StruckMembrane::shapes(double r, double theta) const {
    std::vector<double> values(modes_.size());
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        values[k] = modes_[k].shape(r, theta);
    }
    return values;
}

double StruckMembrane::read(std::span<const double> weights) const noexcept {
    const std::size_t n = std::min(weights.size(), q_.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        sum += weights[k] * q_[k];
    }
    return sum;
}

double StruckMembrane::energy() const noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        const double w = modes_[k].angular_frequency;
        const double rate = damped_frequency_[k] * y_[k] - loss_[k] * q_[k];
        sum += 0.5 * modes_[k].modal_mass * (rate * rate + w * w * q_[k] * q_[k]);
    }
    return sum;
}

double StruckMembrane::energy(std::span<const Striker> strikers) const noexcept {
    double sum = energy();
    for (std::size_t i = 0; i < std::min(strikers.size(), kMaxStrikers); ++i) {
        const Striker& striker = strikers[i];
        sum += 0.5 * striker.mallet.mass * striker.velocity * striker.velocity +
               contact_potential(striker.mallet, displacement(i) - striker.position);
    }
    return sum;
}

void StruckMembrane::rest() noexcept {
    std::fill(q_.begin(), q_.end(), 0.0);
    std::fill(y_.begin(), y_.end(), 0.0);
    for (auto& place : places_) {
        place.displacement = 0.0;
    }
}

}  // namespace percussionist::modal
