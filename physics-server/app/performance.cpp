#include "app/performance.hpp"

#include <stdexcept>
#include <utility>

namespace percussionist::app {

namespace {

/// How long the drum is given to ring after the last stroke [s].
constexpr double kRingOut = 2.5;

}  // namespace

void Performance::load(std::vector<score::Stroke> strokes,
                       const std::shared_ptr<const CapturedMotion>& motion) {
    performing_ = false;
    player_.load(
        std::move(strokes),
        motion ? std::shared_ptr<const body::PlayableClip>(motion, &motion->clip) : nullptr);
    const body::Skeleton usual = body::make_skeleton(simulation_.options().person);
    for (int i = 0; i < usual.size(); ++i) {
        const auto segment = static_cast<std::size_t>(i);
        simulation_.set_limits(i,
                               motion ? motion->limits[segment] : usual.segments[segment].limits);
    }
}

void Performance::play() {
    log_.clear();
    player_.play();
    performing_ = true;
}

void Performance::stop() {
    player_.stop();
    performing_ = false;
}

const std::vector<LoggedContact>& Performance::step() {
    player_.advance();
    events_.clear();
    contacts_.clear();
    simulation_.step(events_);
    if (!simulation_.sane()) {
        throw std::runtime_error("the simulated body went astray at " +
                                 std::to_string(simulation_.time()) + " s");
    }
    for (const sim::ContactEvent& event : events_) {
        const Asked* cause = player_.cause(event);
        LoggedContact contact{event, sequence_++, -1, 0.0, 0.0};
        if (cause != nullptr) {
            contact.stroke = static_cast<int>(cause->stroke);
            contact.asked_time = cause->time;
            contact.asked_speed = cause->shape.impact;
        }
        log_.add(contact);
        contacts_.push_back(contact);
    }
    if (performing_ && !player_.playing() &&
        simulation_.time() >= player_.last_impact() + kRingOut) {
        performing_ = false;
    }
    return contacts_;
}

}  // namespace percussionist::app
