// The drum's samples: which of its ways of moving it takes at which.
#include <algorithm>
#include <cmath>

#include "core/modal/modal_drum.hpp"

namespace percussionist::modal {

namespace {

/// From what is heard to samples; see the header. Of velocity [s/m], position [1/m], pressure
/// [1/Pa].
constexpr std::array<double, 3> kGains{0.39, 470.0, 0.0127};
/// A mallet this far above the head and rising does not come back [m].
constexpr double kClear = 0.003;
/// A follower this far above the head's rest touches nothing [m].
constexpr double kFar = 0.01;
/// A hand that has not got its mallet back by then takes it away [s].
constexpr double kLongestStroke = 0.05;
/// Some 140 dB below a stroke of 2 m/s [J].
constexpr double kInaudible = 1e-16;
/// Of one mode of thousands.
constexpr double kFaint = 1e-21;
/// How often the energy is looked at [samples].
constexpr std::size_t kCheckEvery = 1024;
/// How often moving strikers are placed anew [samples].
constexpr std::size_t kSteerEvery = 16;
/// How fast a follower glides to where it is told [m/s].
constexpr double kGlide = 2.0;
constexpr double kGreatestForce = 1e4;     // [N]
constexpr double kGreatestPosition = 1.0;  // [m]

/// Straight up to 0.6, then bent towards 1.
double limited(double sample) {
    constexpr double kKnee = 0.6;
    const double excess = std::abs(sample) - kKnee;
    if (!(excess > 0.0)) {
        return sample;
    }
    return std::copysign(kKnee + (1 - kKnee) * std::tanh(excess / (1 - kKnee)), sample);
}

/// A sample of a signal from outside; what is no number is 0.
template <class Sample>
double taken(const Sample* signal, std::size_t at, double most) {
    const double value = signal ? static_cast<double>(signal[at]) : 0.0;
    return std::isnan(value) ? 0.0 : std::clamp(value, -most, most);
}

}  // namespace

template <class Sample>
void ModalDrum::render_one(std::span<Sample> out) noexcept {
    Sample* const outputs[] = {out.data()};
    render(DrumSignals<Sample>{.outputs = outputs, .size = out.size()});
}

template <class Sample>
void ModalDrum::render(const DrumSignals<Sample>& signals) noexcept {
    std::size_t done = 0;
    std::size_t begun = 0;
    while (done < signals.size) {
        while (begun < waiting_ && queue_[begun].offset <= done) {
            launch(queue_[begun++].stroke);
        }
        std::size_t length = signals.size - done;
        if (begun < waiting_) {
            length = std::min(length, queue_[begun].offset - done);
        }
        const std::size_t free = free_length(signals, done, length);
        if (free == 0) {
            step(signals, done);
            length = 1;
        } else if (at_rest_) {
            length = free;
            for (Sample* const out : signals.outputs) {
                std::fill_n(out + done, length, Sample(0));
            }
        } else {
            length = free;
            ring(signals, done, length);
        }
        done += length;
    }
    std::move(queue_.begin() + begun, queue_.begin() + waiting_, queue_.begin());
    waiting_ -= begun;
    for (std::size_t i = 0; i < waiting_; ++i) {
        queue_[i].offset -= signals.size;
    }
}

template void ModalDrum::render(const DrumSignals<float>&) noexcept;
template void ModalDrum::render(const DrumSignals<double>&) noexcept;
template void ModalDrum::render_one(std::span<float>) noexcept;
template void ModalDrum::render_one(std::span<double>) noexcept;

/// For how many samples nothing touches the head.
template <class Sample>
std::size_t ModalDrum::free_length(const DrumSignals<Sample>& signals, std::size_t from,
                                   std::size_t most) const noexcept {
    const bool following = follower() < active_;
    if (active_ > (following ? 1 : 0) || (coupled_ && !at_rest_)) {
        return 0;
    }
    if (!signals.force && !following) {
        return most;
    }
    for (std::size_t n = 0; n < most; ++n) {
        if (taken(signals.force, from + n, kGreatestForce) != 0.0 ||
            (following && taken(signals.position, from + n, kGreatestPosition) < kFar)) {
            return n;
        }
    }
    return most;
}

template <class Sample>
void ModalDrum::put(const DrumSignals<Sample>& signals, std::size_t at,
                    const Readings& readings) noexcept {
    const double share = 0.5 - 0.5 * std::cos((static_cast<double>(faded_) + 0.5) * 3.14159265 /
                                              static_cast<double>(kChunk));
    for (std::size_t p = 0; p < signals.outputs.size(); ++p) {
        double reading = p < settings_.pickups.size() ? readings[p] : 0.0;
        if (faded_ < kChunk) {
            reading = share * reading + (1 - share) * fading_[p][faded_];
        }
        const auto hears =
            p < settings_.pickups.size() ? settings_.pickups[p].hears : Pickup::Hears::velocity;
        signals.outputs[p][at] =
            static_cast<Sample>(limited(kGains[static_cast<std::size_t>(hears)] * reading));
    }
    faded_ = std::min(faded_ + 1, kChunk);
}

template <class Sample>
void ModalDrum::ring(const DrumSignals<Sample>& signals, std::size_t from,
                     std::size_t length) noexcept {
    for (std::size_t n = 0; n < length; ++n) {
        if (heard_ == ahead_size_) {
            look_ahead();
        }
        Readings readings{};
        for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
            readings[p] = ahead_[p][heard_];
        }
        ++heard_;
        put(signals, from + n, readings);
    }
}

/// The next chunk of what is heard if nothing happens; the bank waits where it begins.
void ModalDrum::look_ahead() noexcept {
    auto& bank = head_->bank();
    bank.advance(ahead_size_);
    count(ahead_size_);
    ahead_size_ = kChunk;
    heard_ = 0;
    for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
        if (at_rest_) {
            ahead_[p].fill(0.0);
        } else {
            bank.ring(ears_[p].weights, ahead_[p]);
        }
    }
}

/// The bank comes to where it is heard.
void ModalDrum::land() noexcept {
    if (ahead_size_ > 0) {
        head_->bank().advance(heard_);
        count(heard_);
        ahead_size_ = heard_ = 0;
        head_->settle();
    }
}

/// Looks at the energy at the same samples of the sound whatever the blocks.
void ModalDrum::count(std::size_t samples) noexcept {
    since_check_ += samples;
    if (since_check_ < kCheckEvery) {
        return;
    }
    since_check_ = 0;
    coupled_ = head_->coupled();
    if (head_->energy({}) < kInaudible) {
        head_->rest();
        at_rest_ = true;
        faded_ = kChunk;
    } else if (!coupled_) {
        head_->bank().retire(kFaint);
    }
}

template <class Sample>
void ModalDrum::step(const DrumSignals<Sample>& signals, std::size_t at) noexcept {
    land();
    at_rest_ = false;
    steer(taken(signals.position, at, kGreatestPosition));
    head_->step({strikers_.data(), active_}, taken(signals.force, at, kGreatestForce));
    Readings readings{};
    for (std::size_t p = 0; p < settings_.pickups.size(); ++p) {
        readings[p] = head_->reading(p);
    }
    put(signals, at, readings);
    release();
    if (active_ == 0 || (active_ == 1 && courses_[0].follower)) {
        count(1);
    }
}

std::size_t ModalDrum::follower() const noexcept {
    for (std::size_t i = 0; i < active_; ++i) {
        if (courses_[i].follower) {
            return i;
        }
    }
    return active_;
}

/// Moves strikers along the head, and the follower to where its signal wants it.
void ModalDrum::steer(double position) noexcept {
    for (std::size_t i = 0; i < active_; ++i) {
        Course& course = courses_[i];
        if (course.follower) {
            strikers_[i].velocity = (position - strikers_[i].position) * sample_rate_;
            strikers_[i].acceleration = 0.0;
            const double dx = follow_x_ - course.x, dy = follow_y_ - course.y;
            const double way = std::hypot(dx, dy);
            const double speed =
                std::min(kGlide, way * sample_rate_ / static_cast<double>(kSteerEvery));
            course.slide_x = way > 0.0 ? speed * dx / way : 0.0;
            course.slide_y = way > 0.0 ? speed * dy / way : 0.0;
        }
        const bool slides = course.slide_x != 0.0 || course.slide_y != 0.0;
        if (slides && ++course.age % kSteerEvery == 0) {
            const double time = static_cast<double>(kSteerEvery) / sample_rate_;
            course.x += course.slide_x * time;
            course.y += course.slide_y * time;
            head_->place(i, std::hypot(course.x, course.y), std::atan2(course.y, course.x));
        } else if (!slides) {
            ++course.age;
        }
    }
}

void ModalDrum::launch(const Stroke& stroke) noexcept {
    land();
    if (mute_t60_) {
        mute_t60_.reset();
        head_->damp(0.0);
        weigh_pickups();
    }
    add({.mallet = stroke.mallet, .velocity = -stroke.velocity},
        {.x = stroke.r * std::cos(stroke.theta),
         .y = stroke.r * std::sin(stroke.theta),
         .slide_x = stroke.slide_x,
         .slide_y = stroke.slide_y});
    // Where it is told, to the last bit.
    head_->place(active_ - 1, stroke.r, stroke.theta);
    strikers_[active_ - 1].position = head_->displacement(active_ - 1);
    at_rest_ = false;
    coupled_ = coupled_ || head_->stretches();
    since_check_ = 0;
}

void ModalDrum::add(const Striker& striker, const Course& course) noexcept {
    if (active_ == strikers_.size()) {
        remove(follower() == 0 ? 1 : 0);
    }
    strikers_[active_] = striker;
    courses_[active_] = course;
    ++active_;
}

void ModalDrum::follow(double r, double theta, const Mallet& mallet) {
    check(mallet);
    Stroke place;
    place.r = r;
    place.theta = theta;
    check(place);
    follow_x_ = r * std::cos(theta);
    follow_y_ = r * std::sin(theta);
    land();
    std::size_t i = follower();
    if (i == active_) {
        add({.position = kGreatestPosition}, {.follower = true, .x = follow_x_, .y = follow_y_});
        i = follower();
        head_->place(i, r, theta);
    }
    strikers_[i].mallet = mallet;
    strikers_[i].mallet.mass = kDriven;
}

void ModalDrum::unfollow() noexcept {
    land();
    if (follower() < active_) {
        remove(follower());
    }
}

void ModalDrum::release() noexcept {
    const auto longest = static_cast<std::size_t>(kLongestStroke * sample_rate_);
    for (std::size_t i = active_; i-- > 0;) {
        const Striker& striker = strikers_[i];
        const bool clear =
            striker.velocity >= 0.0 && striker.position - head_->displacement(i) > kClear;
        if (!courses_[i].follower && (clear || courses_[i].age > longest)) {
            remove(i);
        }
    }
}

/// The others close up, the oldest first.
void ModalDrum::remove(std::size_t i) noexcept {
    for (; i + 1 < active_; ++i) {
        head_->exchange(i, i + 1);
        strikers_[i] = strikers_[i + 1];
        courses_[i] = courses_[i + 1];
    }
    --active_;
}

}  // namespace percussionist::modal
