#include "core/motion/stick_gestures.hpp"

#include <algorithm>
#include <stdexcept>

namespace percussionist::motion {

namespace {

constexpr std::size_t kMostTaps = 64;
constexpr double kAboveGain = 0.01;  // of each new place of the tip

}  // namespace

StickGestures::StickGestures(const StickGesturesSettings& settings)
    : settings_(settings),
      on_plane_{PlaneStrikeDetector(settings.plane), PlaneStrikeDetector(settings.plane)},
      in_air_{FreeStrikeDetector(settings.free), FreeStrikeDetector(settings.free)},
      fit_(settings.fit) {
    taps_.reserve(kMostTaps);
}

void StickGestures::set(const StickGesturesSettings& settings) {
    const bool other_path = settings.stick != settings_.stick ||
                            settings.frame != settings_.frame || settings.tips != settings_.tips;
    settings_ = settings;
    for (std::size_t end = 0; end < 2; ++end) {
        on_plane_[end].set(settings.plane);
        in_air_[end].set(settings.free);
    }
    fit_.set(settings.fit);
    if (other_path) {
        frame_.reset();
        reset_stick();
    }
}

void StickGestures::set_drum(const Pose& frame_from_drum) {
    frame_from_drum_ = frame_from_drum;
    for (auto& detector : on_plane_) {
        detector.reset();
    }
}

void StickGestures::reset_stick() noexcept {
    for (std::size_t end = 0; end < 2; ++end) {
        on_plane_[end].reset();
        in_air_[end].reset();
    }
    fit_.reset();
    last_tip_.reset();
}

std::optional<Pose> StickGestures::frame_from(const TimedPose& pose) const noexcept {
    if (settings_.frame == 0) {
        return pose.pose;
    }
    const auto world_from_frame = frame_.at(pose.time);
    return world_from_frame ? std::optional(world_from_frame->inverse() * pose.pose) : std::nullopt;
}

StickEvents StickGestures::add(int station, const TimedPose& pose) noexcept {
    if (station < 1 || station > 4) {
        return {};
    }
    const auto verdict = gates_[static_cast<std::size_t>(station - 1)].judge(pose);
    if (verdict == PoseGate::Verdict::kRepeat || verdict == PoseGate::Verdict::kJump) {
        return {};
    }
    if (station == settings_.frame) {
        if (verdict == PoseGate::Verdict::kFresh) {
            frame_.reset();
            reset_stick();  // what it did was seen from another place
        }
        frame_.add(pose);
        return {};
    }
    if (station == settings_.stick) {
        if (verdict == PoseGate::Verdict::kFresh) {
            reset_stick();
        }
        return add_stick(pose);
    }
    return station == settings_.hand ? add_hand(pose) : StickEvents();
}

StickEvents StickGestures::add_stick(const TimedPose& pose) noexcept {
    StickEvents events;
    const auto stick = frame_from(pose);
    if (!stick) {
        return events;
    }
    for (std::size_t end = 0; end < 2; ++end) {
        if (!settings_.tips[end]) {
            continue;
        }
        const Vector3 tip = *stick * *settings_.tips[end];
        if (settings_.detection == Detection::kPlane && frame_from_drum_) {
            const Vector3 tip_drum = frame_from_drum_->inverse() * tip;
            events.plane[end] = on_plane_[end].add({pose.time, tip_drum});
        } else if (settings_.detection == Detection::kFree) {
            events.free[end] = in_air_[end].add({pose.time, tip});
        }
    }
    const Vector3 first = *stick * settings_.tips[0].value_or(Vector3::Zero());
    above_ = last_tip_ ? Vector3(above_ + kAboveGain * (first - above_)) : first;
    last_tip_ = first;
    events.gesture = fit_.add({pose.time, {first, stick->orientation}});
    return events;
}

StickEvents StickGestures::add_hand(const TimedPose& pose) const noexcept {
    StickEvents events;
    const auto hand = frame_from(pose);
    if (hand && frame_from_drum_) {
        const Vector3 hand_drum = frame_from_drum_->inverse() * hand->position;
        const double into = settings_.touch + hand_drum.z();
        events.press =
            Press{place_of(hand_drum), std::clamp(into / settings_.full_press, 0.0, 1.0)};
    }
    return events;
}

std::size_t StickGestures::tap() {
    if (!last_tip_) {
        throw std::runtime_error("no pose of the stick yet");
    }
    return tap(*last_tip_);
}

std::size_t StickGestures::tap(const Vector3& place) {
    if (taps_.size() == kMostTaps) {
        throw std::runtime_error("expected 64 taps at most");
    }
    taps_.push_back(place);
    return taps_.size();
}

FittedPlane StickGestures::fit_drum() {
    FittedPlane fitted = fit_plane(taps_, above_, settings_.plane.tip_radius);
    taps_.clear();
    set_drum(fitted.world_from_drum);
    return fitted;
}

std::size_t StickGestures::repeats() const {
    std::size_t sum = 0;
    for (const PoseGate& gate : gates_) {
        sum += gate.repeats();
    }
    return sum;
}

std::size_t StickGestures::jumps() const {
    std::size_t sum = 0;
    for (const PoseGate& gate : gates_) {
        sum += gate.jumps();
    }
    return sum;
}

}  // namespace percussionist::motion
