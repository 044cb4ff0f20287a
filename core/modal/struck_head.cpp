#include "core/modal/struck_head.hpp"

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
/// Of the tension: a hundredth of a cent in pitch.
constexpr double kUnheard = 1.2e-5;

double valid_rate(double sample_rate) {
    if (!(std::isfinite(sample_rate) && sample_rate > 0.0)) {
        throw std::invalid_argument("struck head: expected a sample rate above 0 [Hz], got " +
                                    std::to_string(sample_rate));
    }
    return sample_rate;
}

void check_place(std::size_t i, double r, double theta) {
    if (i >= StruckHead::kMaxStrikers || !(std::isfinite(r) && r >= 0.0 && std::isfinite(theta))) {
        throw std::invalid_argument(
            "struck head: expected a place of r 0 or more [m] and theta [rad], got " +
            std::to_string(r) + " and " + std::to_string(theta));
    }
}

double held_within(double value, double limit) {
    return std::copysign(std::min(std::abs(value), std::abs(limit)), value);
}

}  // namespace

StruckHead::StruckHead(Resonator resonator, double sample_rate)
    : sample_rate_(valid_rate(sample_rate)),
      period_(1.0 / sample_rate),
      resonator_(std::move(resonator)),
      bank_(resonator_.size(), period_) {
    set_bank();
    for (auto& port : ports_) {
        port.phi.assign(bank_.padded(), 0.0);
    }
    std::for_each_n(ports_.begin(), kMaxStrikers, [](Port& port) { port.used = true; });
    slope_weights_.assign(bank_.padded(), 0.0);
    refresh(true);
}

bool StruckHead::retune(const Body& body, const Loss& loss) {
    const double radius = resonator_.radius();
    if (!resonator_.retune(body, loss)) {
        return false;
    }
    bank();
    set_bank();
    refresh(resonator_.radius() != radius);
    return true;
}

void StruckHead::become(Resonator resonator, long first) {
    ModeBank other(resonator.size(), period_);
    bank();
    resonator_ = std::move(resonator);
    std::swap(bank_, other);
    set_bank();
    bank_.continue_from(other, first);
    for (auto& port : ports_) {
        port.phi.assign(bank_.padded(), 0.0);
    }
    slope_weights_.assign(bank_.padded(), 0.0);
    pickups_.fill({});
    refresh(true);
}

void StruckHead::damp(double least_loss) noexcept {
    least_loss_ = least_loss;
    bank();
    set_bank();
    for (std::size_t p = 0; p < kPorts; ++p) {
        couple(p);
    }
}

void StruckHead::settle() noexcept {
    for (auto& port : ports_) {
        if (port.used) {
            port.displacement = bank_.displacement(port.phi);
        }
    }
    spring_[kTension].elongation = stretches_ ? stretch_of_modes() : 0.0;
}

void StruckHead::set_bank() noexcept {
    for (std::size_t k = 0; k < resonator_.size(); ++k) {
        auto mode = resonator_.mode(k);
        const bool heard = mode.angular_frequency * period_ < kBand * std::numbers::pi;
        mode.loss = std::max(mode.loss, std::min(least_loss_, 0.9 * mode.angular_frequency));
        mode.angular_frequency = heard ? mode.angular_frequency : 0.0;
        bank_.set(k, mode);
    }
}

/// After the modes have changed: shapes, where they did, and all that follows from them.
void StruckHead::refresh(bool other_shapes) {
    const auto* membrane = std::get_if<Membrane>(&resonator_.body());
    stretches_ = membrane && membrane->stretch > 0.0;
    if (stretches_) {
        const double area = std::numbers::pi * membrane->radius * membrane->radius;
        const double b = 0.5 * std::sqrt(membrane->stretch / area);
        for (std::size_t k = 0; k < resonator_.size(); ++k) {
            const bool heard = bank_.mode(k).angular_frequency > 0.0;
            slope_weights_[k] = heard ? b * resonator_.slope(k) : 0.0;
        }
    }
    spring_[kTension].stiffness = stretches_ ? 1.0 : 0.0;
    spring_[kTension].elongation = stretches_ ? stretch_of_modes() : 0.0;
    for (std::size_t p = 0; p < kPorts; ++p) {
        if (p != kTension && other_shapes && ports_[p].used) {
            put(p, ports_[p].spot);
        }
    }
    for (std::size_t p = 0; p < kPorts; ++p) {
        couple(p);
    }
}

void StruckHead::place(std::size_t i, double r, double theta) {
    check_place(i, r, theta);
    put(i, {r, theta, 0.0});
    couple(i);
}

void StruckHead::place_force(double r, double theta) {
    check_place(0, r, theta);
    put(kForce, {r, theta, 0.0});
    couple(kForce);
}

void StruckHead::lay(std::size_t i, const Hand& hand) {
    check(hand);
    if (i >= kMaxHands) {
        throw std::invalid_argument("hand: expected one of " + std::to_string(kMaxHands) +
                                    ", got " + std::to_string(i + 1));
    }
    const HandPoints points = points_of(hand);
    for (std::size_t n = 0; n < HandPoints::kMost; ++n) {
        const std::size_t p = kHandPorts + i * HandPoints::kMost + n;
        Spring& spring = spring_[p];
        const bool presses = n < points.count && points.stiffness > 0.0;
        const double before = spring.stiffness;
        const double stored =
            presses && before > 0.0
                ? spring.elongation * std::sqrt(std::min(1.0, before / points.stiffness))
                : 0.0;
        spring.stiffness = presses ? points.stiffness : 0.0;
        spring.resistance = presses ? points.resistance : 0.0;
        ports_[p].used = presses;
        if (presses) {
            put(p, points.spots[n]);
            couple(p);
        }
        spring.elongation = held_within(ports_[p].displacement, stored);
    }
    springs_stale_ = true;
}

void StruckHead::listen(std::size_t i, const ModeBank::Weights& weights) {
    Pickup& pickup = pickups_.at(i);
    pickup.weights = weights;
    early_.there = false;
    for (std::size_t p = 0; p < kPorts; ++p) {
        pickup.response[p] = ports_[p].used ? bank_.response(weights, ports_[p].phi) : 0.0;
    }
}

void StruckHead::put(std::size_t p, const Spot& spot) {
    apply_pushes();
    Port& port = ports_[p];
    port.spot = spot;
    port.used = true;
    resonator_.shapes(spot, port.phi);
    port.displacement = bank_.displacement(port.phi);
}

/// What a port's force does at all others in use, and at the pickups.
void StruckHead::couple(std::size_t p) noexcept {
    springs_stale_ = true;
    if (!ports_[p].used || p == kTension) {
        return;
    }
    for (std::size_t other = 0; other < kPorts; ++other) {
        if (ports_[other].used && other != kTension) {
            compliance_[p][other] = compliance_[other][p] =
                bank_.compliance(ports_[p].phi, ports_[other].phi);
        }
    }
    for (auto& pickup : pickups_) {
        if (!pickup.weights.q.empty()) {
            pickup.response[p] = bank_.response(pickup.weights, ports_[p].phi);
        }
    }
}

double StruckHead::stretch_of_modes() const noexcept {
    return bank().square_sum(slope_weights_);
}

bool StruckHead::coupled() const noexcept {
    const bool held = std::any_of(ports_.begin() + kHandPorts, ports_.begin() + kTension,
                                  [](const Port& port) { return port.used; });
    if (held || !stretches_) {
        return held;
    }
    // dT = S / (2 A) sum l q^2 = 2 B psi.
    const auto& membrane = *std::get_if<Membrane>(&resonator_.body());
    const double area = std::numbers::pi * membrane.radius * membrane.radius;
    const double b = 0.5 * std::sqrt(membrane.stretch / area);
    return 2 * b * stretch_of_modes() > kUnheard * membrane.tension;
}

Values StruckHead::shapes(double r, double theta) const {
    Values values(bank_.padded(), 0.0);
    resonator_.shapes({r, theta, 0.0}, values);
    return values;
}

ModeBank& StruckHead::bank() noexcept {
    apply_pushes();
    early_.there = false;
    return bank_;
}

double StruckHead::energy(std::span<const Striker> strikers) const noexcept {
    double sum = bank().energy();
    for (const Spring& spring : spring_) {
        sum += spring.energy();
    }
    for (std::size_t i = 0; i < std::min(strikers.size(), kMaxStrikers); ++i) {
        const Striker& striker = strikers[i];
        if (striker.mallet.mass < kDriven) {
            sum += 0.5 * striker.mallet.mass * striker.velocity * striker.velocity;
        }
        sum += contact_potential(striker.mallet, displacement(i) - striker.position);
    }
    return sum;
}

void StruckHead::rest() noexcept {
    push_count_ = 0;
    bank_.rest();
    for (auto& port : ports_) {
        port.displacement = port.rate = 0.0;
    }
    for (auto& spring : spring_) {
        spring.elongation = spring.force = 0.0;
    }
}

void StruckHead::exchange(std::size_t i, std::size_t j) noexcept {
    apply_pushes();
    std::swap(ports_[i], ports_[j]);
    std::swap(compliance_[i], compliance_[j]);
    for (auto& row : compliance_) {
        std::swap(row[i], row[j]);
    }
    for (auto& pickup : pickups_) {
        std::swap(pickup.response[i], pickup.response[j]);
    }
    springs_stale_ = true;
}

}  // namespace percussionist::modal
