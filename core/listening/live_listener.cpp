#include "core/listening/live_listener.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/listening/heard.hpp"
#include "core/listening/stroke_features.hpp"
#include "core/listening/stroke_strength.hpp"

namespace percussionist::listening {

namespace {

constexpr std::ptrdiff_t kRise = 4;  ///< frames within which an attack is steepest
constexpr float kLoudFades = 0.05F;  ///< of what counts as loud, a stroke [nats]
constexpr float kFirstLoud = 1.5F;   ///< the first stroke may be so much below loud [nats]
constexpr float kUnheard = -1000.0F;
constexpr float kEcho = 3.5F;   ///< below the loudest an attack is no stroke to learn from [nats]
constexpr float kFaint = 5.5F;  ///< below it an attack is no stroke of that drum: 24 dB [nats]

float nats(float decibels) {
    return decibels * 0.2302585F;
}

}  // namespace

LiveListener::LiveListener(const LiveSettings& settings, DrumModel model)
    : settings_(settings),
      model_(std::move(model)),
      analyser_(settings.rate),
      waiting_(analyser_.hop(), 0.0),
      frames_(kKept),
      features_(kLiveFeatures, 0.0F) {
    reset();
}

void LiveListener::reset() noexcept {
    analyser_.reset();
    hearing_ = {};
    novelty_.reset();
    filled_ = 0;
    BandFrame silence;
    silence.level.fill(std::log(1e-12F));
    silence.floor.fill(std::log(1e-12F));
    silence.quick.fill(std::log(1e-12F));
    std::fill(frames_.begin(), frames_.end(), silence);
    loud_.fill(kUnheard);
    frame_ = -1;
    attack_ = -1000;
    steepest_ = -1;
    before_ = 0.0F;
}

double LiveListener::time_of_frame(double frame) const noexcept {
    return time_of(frame, analyser_.hop(), settings_.rate);
}

std::size_t LiveListener::next_frame() noexcept {
    told_ = 0;
    ++frame_;
    std::move(frames_.begin() + 1, frames_.end(), frames_.begin());
    analyser_.process(waiting_, frames_.back());
    hearing_.push(frames_.back());
    look_for_attack(novelty_.push(frames_.back(), hearing_.now()));
    if (steepest_ >= 0 && frame_ == steepest_ + static_cast<std::ptrdiff_t>(kLiveReach)) judge();
    return told_;
}

void LiveListener::look_for_attack(float novelty) noexcept {
    const bool audible = loudness(frames_.back()) > nats(settings_.quietest);
    const double gap =
        static_cast<double>((frame_ - attack_) * static_cast<std::ptrdiff_t>(analyser_.hop())) /
        settings_.rate;
    if (steepest_ == frame_ - 1) around_[2] = novelty;
    if (steepest_ >= 0 && frame_ - attack_ <= kRise) {
        if (novelty > around_[1]) {
            steepest_ = frame_;
            around_ = {before_, novelty, 0.0F};
        }
    } else if (steepest_ < 0 && audible && novelty >= settings_.sensitivity && novelty > before_ &&
               gap >= settings_.shortest_gap) {
        attack_ = frame_;
        steepest_ = frame_;
        around_ = {before_, novelty, 0.0F};
        tell({.kind = LiveEvent::Kind::attack,
              .time = time_of_frame(static_cast<double>(frame_)),
              .velocity = 0.0,
              .confidence = 0.5});
    }
    before_ = novelty;
}

void LiveListener::judge() noexcept {
    const std::size_t at = kKept - 1 - kLiveReach;
    stroke_features(frames_, at, hearing_.now(), features_);
    const double within = static_cast<double>(peak_between(around_[0], around_[1], around_[2]));
    const double time = time_of_frame(static_cast<double>(steepest_) + within);
    steepest_ = -1;
    const std::span<const float> said = model_.live.evaluate(features_);
    Odds odds{};
    for (std::size_t c = 0; c < kDrumClasses; ++c) odds[c] = said[c] - model_.live_threshold[c];
    for (const Verdict& verdict : verdicts(odds)) {
        tell({.kind = LiveEvent::Kind::drum,
              .time = time,
              .drum = verdict.drum,
              .velocity = velocity(verdict.drum),
              .confidence = verdict.confidence});
    }
    judge_own(time);
}

void LiveListener::judge_own(double time) noexcept {
    const std::size_t at = kKept - 1 - kLiveReach;
    const StrokePrint print = print_of(frames_, at);
    const float power = added_power(frames_, at, DrumClass::other);
    if (left_to_learn_ > 0) {
        OwnDrum& drum = own_[learning_];
        if (drum.strokes > 0 && power < drum.loudest - kEcho) return;
        drum.learn(print, power);
        --left_to_learn_;
        return;
    }
    const auto match = own_.nearest(print);
    if (match && power > own_[match->drum].loudest - kFaint) {
        tell({.kind = LiveEvent::Kind::own_drum,
              .time = time,
              .own = match->drum,
              .velocity = velocity_of(power, own_[match->drum].loudest),
              .confidence = match->confidence});
    }
}

double LiveListener::velocity(DrumClass drum) noexcept {
    const float power = added_power(frames_, kKept - 1 - kLiveReach, drum);
    float& loud = loud_[index(drum)];
    loud = loud == kUnheard ? power + kFirstLoud : std::max(power, loud - kLoudFades);
    return velocity_of(power, loud);
}

void LiveListener::tell(const LiveEvent& event) noexcept {
    if (told_ < kMostEvents) events_[told_++] = event;
}

void LiveListener::learn(std::size_t own, int strokes) noexcept {
    own_.forget(own);
    learning_ = own;
    left_to_learn_ = strokes;
}

}  // namespace percussionist::listening
