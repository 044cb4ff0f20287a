#include "core/modal/modal_drum.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

/// From the head's velocity [m/s] to samples; see the header.
constexpr double kGain = 0.39;
/// A mallet this far above the head and rising does not come back [m].
constexpr double kClear = 0.003;
/// A hand that has not got its mallet back by then takes it away [s].
constexpr double kLongestStroke = 0.05;
/// Some 140 dB below a stroke of 2 m/s [J].
constexpr double kInaudible = 1e-16;
/// How often the energy is looked at [samples].
constexpr std::size_t kCheckEvery = 1024;

/// Straight up to 0.6, then bent towards 1.
double limited(double sample) {
    constexpr double kKnee = 0.6;
    const double excess = std::abs(sample) - kKnee;
    if (!(excess > 0.0)) {
        return sample;
    }
    return std::copysign(kKnee + (1 - kKnee) * std::tanh(excess / (1 - kKnee)), sample);
}

void check_place(const char* what, double r, double theta) {
    if (!(std::isfinite(r) && r >= 0.0 && std::isfinite(theta))) {
        throw std::invalid_argument(std::string(what) +
                                    ": expected r of 0 or more [m] and theta [rad], got " +
                                    std::to_string(r) + " and " + std::to_string(theta));
    }
}

void check_modes(std::size_t count) {
    if (count < 1 || count > ModalDrum::kMaxModes) {
        throw std::invalid_argument("modes: expected a number from 1 to " +
                                    std::to_string(ModalDrum::kMaxModes) + ", got " +
                                    std::to_string(count));
    }
}

}  // namespace

void check(const Stroke& stroke) {
    if (!(stroke.velocity > 0.0 && stroke.velocity <= 100.0)) {
        throw std::invalid_argument("velocity: expected a number above 0, at most 100 [m/s], got " +
                                    std::to_string(stroke.velocity));
    }
    check_place("stroke", stroke.r, stroke.theta);
    check(stroke.mallet);
}

ModalDrum::ModalDrum(const DrumSettings& settings, double sample_rate)
    : settings_(settings), sample_rate_(sample_rate) {
    check_modes(settings.modes);
    head_.emplace(settings.membrane, settings.decay, settings.modes, sample_rate);
    set_pickup(settings.pickup_r, settings.pickup_theta);
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

template <class Sample>
void ModalDrum::render(std::span<Sample> out) noexcept {
    std::array<double, ModeBank::kMostAtOnce> velocities;
    std::size_t done = 0;
    std::size_t begun = 0;
    while (done < out.size()) {
        while (begun < waiting_ && queue_[begun].offset <= done) {
            launch(queue_[begun++].stroke);
        }
        std::size_t length = out.size() - done;
        if (begun < waiting_) {
            length = std::min(length, queue_[begun].offset - done);
        }
        if (at_rest_) {
            std::fill_n(out.data() + done, length, Sample(0));
        } else {
            length = run_length(length);
            const std::span run_of(velocities.data(), length);
            run(run_of);
            std::transform(run_of.begin(), run_of.end(), out.data() + done, [](double velocity) {
                return static_cast<Sample>(limited(kGain * velocity));
            });
        }
        done += length;
    }
    std::move(queue_.begin() + begun, queue_.begin() + waiting_, queue_.begin());
    waiting_ -= begun;
    for (std::size_t i = 0; i < waiting_; ++i) {
        queue_[i].offset -= out.size();
    }
}

template void ModalDrum::render(std::span<float>) noexcept;
template void ModalDrum::render(std::span<double>) noexcept;

/// Looks at the energy at the same samples of the sound whatever the blocks.
std::size_t ModalDrum::run_length(std::size_t most) const noexcept {
    return active_ > 0 ? 1 : std::min({most, ModeBank::kMostAtOnce, kCheckEvery - since_check_});
}

void ModalDrum::run(std::span<double> velocities) noexcept {
    if (active_ > 0) {
        head_->step({mallets_.data(), active_});
        velocities[0] = head_->bank().velocity(pickup_);
        release_mallets();
        since_check_ = 0;
        return;
    }
    head_->bank().ring(pickup_, velocities);
    since_check_ += velocities.size();
    if (since_check_ == kCheckEvery) {
        since_check_ = 0;
        head_->bank().rest_the_faint();
        if (head_->bank().energy() < kInaudible) {
            head_->rest();
            at_rest_ = true;
        }
    }
}

void ModalDrum::launch(const Stroke& stroke) noexcept {
    if (hand_t60_) {
        hand_t60_.reset();
        settle();
    }
    if (active_ == mallets_.size()) {
        remove_mallet(0);
    }
    head_->place(active_, stroke.r, stroke.theta);
    mallets_[active_] = {.mallet = stroke.mallet,
                         .position = head_->displacement(active_),
                         .velocity = -stroke.velocity};
    ages_[active_] = 0;
    ++active_;
    at_rest_ = false;
}

void ModalDrum::release_mallets() noexcept {
    const auto longest = static_cast<std::size_t>(kLongestStroke * sample_rate_);
    for (std::size_t i = active_; i-- > 0;) {
        const Striker& mallet = mallets_[i];
        const bool clear =
            mallet.velocity >= 0.0 && mallet.position - head_->displacement(i) > kClear;
        if (clear || ++ages_[i] > longest) {
            remove_mallet(i);
        }
    }
}

/// The others close up, the oldest first.
void ModalDrum::remove_mallet(std::size_t i) noexcept {
    for (; i + 1 < active_; ++i) {
        head_->exchange(i, i + 1);
        mallets_[i] = mallets_[i + 1];
        ages_[i] = ages_[i + 1];
    }
    --active_;
}

void ModalDrum::tune(const Membrane& membrane, const Decay& decay) {
    check(membrane);
    check(decay);
    settings_.membrane = membrane;
    settings_.decay = decay;
    const bool other_size = membrane.radius != head_->modes()[0].radius;
    settle();
    if (other_size) {
        set_pickup(settings_.pickup_r, settings_.pickup_theta);
    }
}

void ModalDrum::set_modes(std::size_t count) {
    check_modes(count);
    StruckMembrane other(settings_.membrane, settings_.decay, count, sample_rate_);
    other.continue_from(*head_);
    head_ = std::move(other);
    active_ = 0;
    settings_.modes = count;
    set_pickup(settings_.pickup_r, settings_.pickup_theta);
    settle();
}

void ModalDrum::set_pickup(double r, double theta) {
    check_place("pickup", r, theta);
    pickup_shapes_ = head_->shapes(r, theta);
    pickup_.q.resize(pickup_shapes_.size());
    pickup_.y.resize(pickup_shapes_.size());
    head_->bank().set_weights(pickup_shapes_, pickup_);
    settings_.pickup_r = r;
    settings_.pickup_theta = theta;
}

void ModalDrum::mute(double t60) {
    if (!(t60 > 0.0)) {
        throw std::invalid_argument("mute: expected a time above 0 [s], got " +
                                    std::to_string(t60));
    }
    hand_t60_ = t60;
    settle();
}

void ModalDrum::reset() noexcept {
    head_->rest();
    at_rest_ = true;
    active_ = 0;
    waiting_ = 0;
    since_check_ = 0;
}

void ModalDrum::settle() {
    Decay decay = settings_.decay;
    if (hand_t60_) {
        decay.t60_low = std::min(decay.t60_low, *hand_t60_);
        decay.t60_high = std::min(decay.t60_high, *hand_t60_);
    }
    head_->tune(settings_.membrane, decay);
    head_->bank().set_weights(pickup_shapes_, pickup_);
}

}  // namespace percussionist::modal
