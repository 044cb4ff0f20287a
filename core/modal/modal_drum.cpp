#include "core/modal/modal_drum.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

void check_place(const char* what, double r, double theta) {
    if (!(std::isfinite(r) && r >= 0.0 && std::isfinite(theta))) {
        throw std::invalid_argument(std::string(what) +
                                    ": expected r of 0 or more [m] and theta [rad], got " +
                                    std::to_string(r) + " and " + std::to_string(theta));
    }
}

void check_pickup(const Pickup& pickup) {
    check_place("pickup", pickup.r, pickup.theta);
    if (!(std::abs(pickup.elevation) <= 1.6)) {
        throw std::invalid_argument("pickup: expected an elevation from -1.6 to 1.6 [rad], got " +
                                    std::to_string(pickup.elevation));
    }
}

/// Of air, over 2 pi times a distance of 1 m: from integrals of acceleration to pressure.
constexpr double kFarAway = 1.2 / (2 * 3.14159265358979);

/// i^m, split into what is heard in phase and what a quarter of a period later.
struct Phase {
    double in_phase;
    double later;
};

Phase power_of_i(int m) {
    constexpr std::array<Phase, 4> kPowers{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
    return kPowers[static_cast<std::size_t>(m) % 4];
}

}  // namespace

void check(const Stroke& stroke) {
    if (!(stroke.velocity > 0.0 && stroke.velocity <= 100.0)) {
        throw std::invalid_argument("velocity: expected a number above 0, at most 100 [m/s], got " +
                                    std::to_string(stroke.velocity));
    }
    check_place("stroke", stroke.r, stroke.theta);
    if (!(std::abs(stroke.slide_x) <= 100.0 && std::abs(stroke.slide_y) <= 100.0)) {
        throw std::invalid_argument("slide: expected at most 100 [m/s] each way");
    }
    check(stroke.mallet);
}

ModalDrum::ModalDrum(const DrumSettings& settings, double sample_rate)
    : settings_(settings), sample_rate_(sample_rate) {
    if (settings.pickups.empty() || settings.pickups.size() > kMaxPickups) {
        throw std::invalid_argument("pickups: expected 1 to " + std::to_string(kMaxPickups) +
                                    ", got " + std::to_string(settings.pickups.size()));
    }
    std::for_each(settings.pickups.begin(), settings.pickups.end(), check_pickup);
    head_.emplace(Resonator(settings.body, settings.loss, settings.choice), sample_rate);
    read_pickups();
}

bool ModalDrum::strike(std::size_t offset, const Stroke& stroke) {
    check(stroke);
    if (waiting_ == kQueue) {
        return false;
    }
    std::size_t i = waiting_++;
    for (; i > 0 && queue_[i - 1].offset > offset; --i) {
        queue_[i] = queue_[i - 1];
    }
    queue_[i] = {offset, stroke};
    return true;
}

void ModalDrum::tune(const Body& body, const Loss& loss) {
    land();
    fade();
    if (!head_->retune(body, loss)) {
        head_->become(Resonator(body, loss, settings_.choice), 0);
    }
    settings_.body = body;
    settings_.loss = loss;
    read_pickups();
}

void ModalDrum::choose(const Choice& choice) {
    Resonator resonator(settings_.body, settings_.loss, choice);
    land();
    fade();
    head_->become(std::move(resonator),
                  static_cast<long>(choice.skip) - static_cast<long>(settings_.choice.skip));
    settings_.choice = choice;
    read_pickups();
}

void ModalDrum::set_pickup(std::size_t i, const Pickup& pickup) {
    check_pickup(pickup);
    if (i >= settings_.pickups.size()) {
        throw std::invalid_argument("pickup: expected one of " +
                                    std::to_string(settings_.pickups.size()) + ", got " +
                                    std::to_string(i + 1));
    }
    land();
    fade();
    settings_.pickups[i] = pickup;
    read_pickups();
}

void ModalDrum::lay(std::size_t i, const Hand& hand) {
    land();
    head_->lay(i, hand);
    coupled_ = head_->coupled();
    since_check_ = 0;
}

void ModalDrum::force_at(double r, double theta) {
    land();
    head_->place_force(r, theta);
}

void ModalDrum::mute(double t60) {
    if (!(t60 > 0.0)) {
        throw std::invalid_argument("mute: expected a time above 0 [s], got " +
                                    std::to_string(t60));
    }
    land();
    mute_t60_ = t60;
    head_->damp(loss_of_t60(t60));
    weigh_pickups();
}

void ModalDrum::reset() noexcept {
    head_->rest();
    at_rest_ = true;
    active_ = 0;
    waiting_ = 0;
    since_check_ = 0;
    ahead_size_ = heard_ = 0;
    faded_ = kChunk;
    coupled_ = head_->coupled();
}

/// Before what is heard changes at once: what would have been heard fades out.
void ModalDrum::fade() noexcept {
    if (at_rest_) {
        return;
    }
    std::array<double, kChunk> old{};
    for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
        head_->bank().ring(ears_[p].weights, old);
        for (std::size_t i = faded_; i < kChunk; ++i) {
            // Within a fade: about where it was going.
            const double share = static_cast<double>(i) / kChunk;
            old[i - faded_] = share * old[i - faded_] + (1 - share) * fading_[p][i];
        }
        fading_[p] = old;
    }
    faded_ = 0;
}

/// Where in each mode the pickups hear, for the modes and pickups as they are.
void ModalDrum::read_pickups() {
    const auto& bank = head_->bank();
    const auto modes = head_->modes();
    for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
        const Pickup& pickup = settings_.pickups[p];
        auto& ear = ears_[p];
        const bool afar = pickup.hears == Pickup::Hears::pressure && !modes.empty();
        ear.weights.q.assign(bank.padded(), 0.0);
        ear.weights.y.assign(bank.padded(), 0.0);
        ear.weights.force.assign(afar ? bank.padded() : 0, 0.0);
        ear.later.assign(afar ? bank.padded() : 0, 0.0);
        ear.shape = head_->shapes(pickup.r, pickup.theta);
        const auto* given = std::get_if<GivenModes>(&head_->resonator().body());
        if (given && pickup.hears == Pickup::Hears::pressure) {
            heard_weights(*given, ear.shape);
        }
        for (std::size_t k = 0; afar && k < modes.size(); ++k) {
            const Phase phase = power_of_i(modes[k].diameters);
            const double far = kFarAway * radiation(modes[k], pickup.elevation, pickup.theta);
            ear.shape[k] = phase.in_phase * far;
            ear.later[k] = phase.later * far;
        }
    }
    weigh_pickups();
}

/// How much of what a mode does they hear, for its frequency and loss.
void ModalDrum::weigh_pickups() noexcept {
    const auto& bank = head_->bank();
    for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
        auto& ear = ears_[p];
        if (!ear.later.empty()) {
            bank.read_acceleration(ear.shape, ear.later, ear.weights);
        } else if (settings_.pickups[p].hears == Pickup::Hears::position) {
            ear.weights.q = ear.shape;
        } else {
            bank.read_velocity(ear.shape, ear.weights);
        }
        head_->listen(p, ear.weights);
    }
    coupled_ = head_->coupled();
    since_check_ = 0;
}

}  // namespace percussionist::modal
