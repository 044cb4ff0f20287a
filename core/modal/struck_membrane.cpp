#include "core/modal/struck_membrane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

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
    : sample_rate_(sample_rate), period_(1.0 / sample_rate), bank_(mode_count, period_) {
    if (!(std::isfinite(sample_rate) && sample_rate > 0.0)) {
        throw std::invalid_argument("struck membrane: expected a sample rate above 0 [Hz], got " +
                                    std::to_string(sample_rate));
    }
    check(decay);
    modes_ = membrane_modes(membrane, mode_count);
    set_modes(decay);
    places_[0].phi.assign(bank_.padded(), 0.0);
    evaluate(places_[0]);
    places_.fill(places_[0]);
    for (std::size_t i = 0; i < kMaxStrikers; ++i) {
        set_compliances(i);
    }
}

void StruckMembrane::tune(const Membrane& membrane, const Decay& decay) {
    check(decay);
    const double radius_before = modes_.empty() ? membrane.radius : modes_[0].radius;
    retune(modes_, membrane);
    set_modes(decay);
    for (auto& place : places_) {
        if (membrane.radius != radius_before) {
            evaluate(place);
        }
    }
    for (std::size_t i = 0; i < kMaxStrikers; ++i) {
        set_compliances(i);
    }
}

void StruckMembrane::set_modes(const Decay& decay) {
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        const double w = modes_[k].angular_frequency;
        const double s = loss(decay, modes_[0].angular_frequency, w);
        const bool heard = w * period_ < kBand * std::numbers::pi;
        bank_.set(k, {.angular_frequency = heard ? w : 0.0,
                      .loss = std::min(s, kGreatestDamping * w),
                      .mass = modes_[k].modal_mass});
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
    evaluate_shapes(modes_, place.r, place.theta, place.phi);
    place.displacement = bank_.displacement(place.phi);
}

void StruckMembrane::set_compliances(std::size_t i) {
    for (std::size_t j = 0; j < kMaxStrikers; ++j) {
        compliance_[i][j] = compliance_[j][i] = bank_.compliance(places_[i].phi, places_[j].phi);
    }
}

void StruckMembrane::step(std::span<Striker> strikers) noexcept {
    const auto acting = strikers.first(std::min(strikers.size(), kMaxStrikers));
    places_[0].free_displacement = bank_.swing(places_[0].phi);
    for (std::size_t i = 1; i < acting.size(); ++i) {
        places_[i].free_displacement = bank_.displacement(places_[i].phi);
    }
    const bool touched = find_forces(acting);
    for (std::size_t i = 0; i < acting.size(); ++i) {
        Striker& striker = acting[i];
        const double acceleration = striker.acceleration + striker.force / striker.mallet.mass;
        striker.position += period_ * (striker.velocity + 0.5 * period_ * acceleration);
        striker.velocity += period_ * acceleration;
        if (striker.force > 0.0) {
            bank_.push(-striker.force, places_[i].phi);
        }
        double displacement = places_[i].free_displacement;
        for (std::size_t j = 0; touched && j < acting.size(); ++j) {
            displacement -= compliance_[i][j] * acting[j].force;
        }
        places_[i].displacement = displacement;
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

std::vector<double> StruckMembrane::shapes(double r, double theta) const {
    std::vector<double> values(bank_.padded(), 0.0);
    evaluate_shapes(modes_, r, theta, values);
    return values;
}

double StruckMembrane::energy(std::span<const Striker> strikers) const noexcept {
    double sum = bank_.energy();
    for (std::size_t i = 0; i < std::min(strikers.size(), kMaxStrikers); ++i) {
        const Striker& striker = strikers[i];
        sum += 0.5 * striker.mallet.mass * striker.velocity * striker.velocity +
               contact_potential(striker.mallet, displacement(i) - striker.position);
    }
    return sum;
}

void StruckMembrane::rest() noexcept {
    bank_.rest();
    for (auto& place : places_) {
        place.displacement = 0.0;
    }
}

void StruckMembrane::continue_from(const StruckMembrane& other) noexcept {
    bank_.continue_from(other.bank_);
    for (auto& place : places_) {
        place.displacement = bank_.displacement(place.phi);
    }
}

void StruckMembrane::exchange(std::size_t i, std::size_t j) noexcept {
    std::swap(places_[i], places_[j]);
    std::swap(compliance_[i], compliance_[j]);
    for (auto& row : compliance_) {
        std::swap(row[i], row[j]);
    }
}

}  // namespace percussionist::modal
