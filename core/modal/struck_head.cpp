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

/// Each pace's steps to one of the pace before; three paces: down to 1/256 of a sample.
constexpr double kFiner = static_cast<double>(Foresight::kSpan);
constexpr int kPaces = 3;

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

StruckHead::Pace::Pace(std::size_t modes, double step)
    : period(step), flesh_keeps(std::exp(-step / kFleshRelaxation)), bank(modes, step) {}

StruckHead::StruckHead(Resonator resonator, double sample_rate)
    : sample_rate_(valid_rate(sample_rate)),
      resonator_(std::move(resonator)),
      reserve_(kFullReserve) {
    double period = 1.0 / sample_rate;
    while (paces_.size() < kPaces) {
        paces_.emplace_back(resonator_.size(), period);
        period /= kFiner;
    }
    set_modes();
    for (auto& port : ports_) {
        port.phi.assign(bank().padded(), 0.0);
    }
    std::for_each_n(ports_.begin(), kMaxStrikers, [](Port& port) { port.used = true; });
    slope_weights_.assign(bank().padded(), 0.0);
    refresh(true);
}

bool StruckHead::retune(const Body& body, const Loss& loss) {
    const double radius = resonator_.radius();
    if (!resonator_.retune(body, loss)) {
        return false;
    }
    set_modes();
    refresh(resonator_.radius() != radius);
    return true;
}

void StruckHead::become(Resonator resonator, long first) {
    const ModeBank before = std::move(bank());
    resonator_ = std::move(resonator);
    for (Pace& pace : paces_) {
        pace = Pace(resonator_.size(), pace.period);
    }
    set_modes();
    bank().continue_from(before, first);
    for (auto& port : ports_) {
        port.phi.assign(bank().padded(), 0.0);
    }
    slope_weights_.assign(bank().padded(), 0.0);
    pickups_.fill({});
    refresh(true);
}

void StruckHead::damp(double least_loss) noexcept {
    least_loss_ = least_loss;
    set_modes();
}

void StruckHead::settle() noexcept {
    for (auto& port : ports_) {
        if (port.used) {
            port.displacement = bank().displacement(port.phi);
        }
    }
    spring_[kTension].elongation = stretches_ ? stretch_of_modes() : 0.0;
}

/// The modes of the sample's bank; the others follow when they are needed.
void StruckHead::set_modes() noexcept {
    ModeBank& modes = bank();
    const double period = paces_.front().period;
    for (std::size_t k = 0; k < resonator_.size(); ++k) {
        auto mode = resonator_.mode(k);
        const bool heard = mode.angular_frequency * period < kBand * std::numbers::pi;
        mode.loss = std::max(mode.loss, std::min(least_loss_, 0.9 * mode.angular_frequency));
        mode.angular_frequency = heard ? mode.angular_frequency : 0.0;
        modes.set(k, mode);
    }
    for (Pace& pace : paces_) {
        pace.modes_stale = true;
        pace.sight.forget();
    }
    stale_springs();
}

void StruckHead::stale_springs() noexcept {
    for (Pace& pace : paces_) {
        pace.springs_stale = true;
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
            const bool heard = bank().mode(k).angular_frequency > 0.0;
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
    stale_springs();
}

void StruckHead::place(std::size_t i, double r, double theta) {
    check_place(i, r, theta);
    put(i, {r, theta, 0.0});
}

void StruckHead::place_force(double r, double theta) {
    check_place(0, r, theta);
    put(kForce, {r, theta, 0.0});
}

void StruckHead::lay(std::size_t i, const Hand& hand) {
    check(hand);
    if (i >= kMaxHands) {
        throw std::invalid_argument("hand: expected one of " + std::to_string(kMaxHands) +
                                    ", got " + std::to_string(i + 1));
    }
    bank();
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
        }
        spring.elongation = held_within(ports_[p].displacement, stored);
    }
    stale_springs();
}

void StruckHead::listen(std::size_t i, const ModeBank::Weights& weights) {
    bank();
    pickups_.at(i) = weights;
    for (Pace& pace : paces_) {
        pace.sight.forget_output(kPorts + i);
    }
}

void StruckHead::put(std::size_t p, const Spot& spot) {
    Port& port = ports_[p];
    port.spot = spot;
    port.used = true;
    const ModeBank& modes = bank();
    resonator_.shapes(spot, port.phi);
    port.displacement = modes.displacement(port.phi);
    forget(p);
}

/// What its force does is to be found anew, and what forces do there.
void StruckHead::forget(std::size_t p) noexcept {
    for (Pace& pace : paces_) {
        pace.sight.forget_input(p);
        pace.sight.forget_output(p);
        pace.springs_stale = true;
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
    Values values(bank().padded(), 0.0);
    resonator_.shapes({r, theta, 0.0}, values);
    return values;
}

ModeBank& StruckHead::bank() noexcept {
    land(paces_.front());
    return paces_.front().bank;
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
    bank().rest();
    for (auto& port : ports_) {
        port.displacement = port.rate = 0.0;
    }
    for (auto& spring : spring_) {
        spring.elongation = spring.force = 0.0;
    }
}

void StruckHead::exchange(std::size_t i, std::size_t j) noexcept {
    bank();
    std::swap(ports_[i], ports_[j]);
    forget(i);
    forget(j);
}

}  // namespace percussionist::modal
