#include "app/player.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::app {

using body::Hand;

namespace {

constexpr std::array<Hand, 2> kHands{Hand::left, Hand::right};
/// Time to raise the sticks before the first stroke [s].
constexpr double kLead = 1.0;
/// A stroke so near its impact is no longer bent [s].
constexpr double kCommitted = 0.10;
/// A contact further than this from any stroke's time came of none [s].
constexpr double kCauseWindow = 0.045;
constexpr std::size_t kRemembered = 4;

}  // namespace

void Player::load(std::vector<score::Stroke> strokes) {
    stop();
    strokes_ = std::move(strokes);
    for (const Hand hand : kHands) state(hand).strokes.clear();
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
        hands_[strokes_[i].hand].strokes.push_back(i);
    }
}

void Player::play() {
    stop();
    const double first = strokes_.empty() ? 0.0 : strokes_.front().time;
    origin_ = simulation_.frontier() + kLead - std::min(first, kLead) / tempo_;
    asked_ = dropped_ = 0;
    last_impact_ = simulation_.frontier();
    for (const Hand hand : kHands) state(hand).next = 0;
    playing_ = true;
}

void Player::stop() {
    if (!playing_) return;
    playing_ = false;
    for (const Hand hand : kHands) {
        HandState& h = state(hand);
        const bool aiming = simulation_.path(hand).aiming(simulation_.frontier());
        if (!aiming) continue;
        simulation_.rest(hand);
        if (!h.recent.empty()) h.recent.pop_back();
        --asked_;
    }
}

void Player::set_tempo(double factor) {
    const double now = simulation_.frontier();
    origin_ = now - (now - origin_) * tempo_ / factor;
    tempo_ = factor;
    if (!playing_) return;
    for (const Hand hand : kHands) retime(hand);
}

void Player::retime(Hand hand) {
    HandState& h = state(hand);
    const double now = simulation_.frontier();
    if (!simulation_.path(hand).aiming(now) || h.recent.empty()) return;
    Asked& pending = h.recent.back();
    const double time = impact_time(pending.stroke);
    if (pending.time - now < kCommitted || time - now < kCommitted) return;
    const score::Stroke& s = strokes_[pending.stroke];
    if (simulation_.strike(hand, time, s.speed, s.height)) {
        pending.time = time;
        last_impact_ = std::max(last_impact_, time);
    }
}

void Player::advance() {
    given_.clear();
    if (!playing_) return;
    for (const Hand hand : kHands) advance(hand);
    const bool over = std::all_of(kHands.begin(), kHands.end(), [&](Hand hand) {
        return state(hand).next == state(hand).strokes.size() &&
               !simulation_.path(hand).aiming(simulation_.frontier());
    });
    if (over) playing_ = false;
}

void Player::advance(Hand hand) {
    HandState& h = state(hand);
    const double now = simulation_.frontier();
    while (h.next < h.strokes.size() && !simulation_.path(hand).aiming(now)) {
        const std::size_t i = h.strokes[h.next++];
        const score::Stroke& s = strokes_[i];
        const double time = impact_time(i);
        if (!simulation_.strike(hand, time, s.speed, s.height)) {
            ++dropped_;
            continue;
        }
        ++asked_;
        last_impact_ = std::max(last_impact_, time);
        h.recent.push_back({i, time});
        given_.push_back({i, time});
        if (h.recent.size() > kRemembered) h.recent.pop_front();
    }
}

const Asked* Player::cause(const sim::ContactEvent& contact) const {
    const Asked* nearest = nullptr;
    double least = kCauseWindow;
    for (const Asked& asked : hands_[static_cast<int>(contact.hand)].recent) {
        const double distance = std::abs(asked.time - contact.instant);
        if (distance < least) {
            least = distance;
            nearest = &asked;
        }
    }
    return nearest;
}

}  // namespace percussionist::app
