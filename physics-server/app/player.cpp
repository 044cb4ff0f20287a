#include "app/player.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::app {

using body::Hand;
using body::kHands;

namespace {

/// Time to raise the sticks before the first stroke [s].
constexpr double kLead = 1.0;
/// A stroke so near its impact is no longer bent [s].
constexpr double kCommitted = 0.10;
/// One so near is bent in time only: the stick comes down already [s].
constexpr double kShaped = 0.30;
/// A contact further than this from any stroke's time came of none [s].
constexpr double kCauseWindow = 0.045;
constexpr std::size_t kRemembered = 4;
/// No stroke is asked for that is faster [m/s].
constexpr double kFastest = 6.0;
/// A captured motion has come to rest so long after its end [s].
constexpr double kAtRest = 0.2;
/// Between two strokes of a hand that takes over from the other, at least [s].
constexpr double kSoonest = 0.12;

/// A stroke as its gesture has it: `height` times as high.
body::StrokeShape shape_of(const score::Stroke& stroke,
                           const std::optional<body::Gesture>& in_place, double height) {
    const auto& all = body::built_in_gestures();
    const body::StrokeShape& usual =
        in_place ? in_place->shape : all[static_cast<std::size_t>(stroke.nuance)].shape;
    // The dynamic: how much faster a legato stroke would be than the legato stroke of the table.
    const double dynamic =
        stroke.speed / score::impact_ratio(stroke.nuance) / all.front().shape.impact;
    body::StrokeShape shape = body::scaled(usual, std::min(dynamic, kFastest / usual.impact));
    shape.rise *= height;
    return shape;
}

}  // namespace

void Player::load(std::vector<score::Stroke> strokes,
                  std::shared_ptr<const body::PlayableClip> clip) {
    stop();
    strokes_ = std::move(strokes);
    clip_ = std::move(clip);
    share_out();
}

void Player::share_out() {
    leading_ = wished_leading_;
    for (HandState& h : hands_) {
        h.strokes.clear();
        h.next = 0;
    }
    const int exchange = leading_ == Hand::right || clip_ ? 0 : 1;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
        hands_[strokes_[i].hand ^ exchange].strokes.push_back(i);
    }
}

void Player::play() {
    stop();
    share_out();
    const double now = simulation_.frontier();
    const double first = strokes_.empty() ? 0.0 : strokes_.front().time;
    tempo_.begin(now, 0.0);
    const double lead = std::max(0.0, kLead - (tempo_.time_of(first) - now));
    tempo_.begin(now + lead, 0.0);
    asked_ = dropped_ = 0;
    last_impact_ = now;
    playing_ = true;
    if (clip_) simulation_.play(clip_, [this](double t) { return tempo_.position(t); });
}

void Player::stop() {
    if (!playing_) return;
    playing_ = false;
    for (const Hand hand : kHands) {
        HandState& h = state(hand);
        if (!busy(hand)) continue;
        if (!clip_) simulation_.rest(hand);
        if (!h.recent.empty()) h.recent.pop_back();
        --asked_;
    }
    if (clip_) simulation_.follow_strokes();
}

/// Whether a stroke that it was given is still to come.
bool Player::busy(Hand hand) const {
    const double now = simulation_.frontier();
    if (!clip_) return simulation_.path(hand).aiming(now);
    const auto& recent = hands_[static_cast<int>(hand)].recent;
    return !recent.empty() && recent.back().time > now;
}

void Player::set_tempo(double factor, double seconds) {
    tempo_.glide(simulation_.frontier(), factor, seconds);
    rebend();
}

void Player::set_rubato(double depth, double period) {
    tempo_.sway(simulation_.frontier(), depth, period);
    rebend();
}

void Player::set_gesture(Hand hand, std::optional<body::Gesture> gesture) {
    state(hand).gesture = std::move(gesture);
    rebend();
}

void Player::set_height(double factor) {
    height_ = factor;
    rebend();
}

void Player::rebend() {
    if (!playing_) return;
    for (const Hand hand : kHands) rebend(hand);
}

void Player::rebend(Hand hand) {
    HandState& h = state(hand);
    const double now = simulation_.frontier();
    if (!busy(hand) || h.recent.empty()) return;
    Asked bent = h.recent.back();
    bent.time = impact_time(bent.stroke);
    if (clip_) {
        h.recent.back().time = bent.time;
        return;
    }
    const double left = std::min(h.recent.back().time, bent.time) - now;
    if (left < kCommitted) return;
    if (left > kShaped) shape(hand, bent);
    if (give(hand, bent)) h.recent.back() = bent;
}

/// How the stroke is to be played as things are now.
void Player::shape(Hand hand, Asked& asked) const {
    const score::Stroke& s = strokes_[asked.stroke];
    asked.hand = hand;
    asked.shape = clip_ ? clip_->strokes()[asked.stroke].shape
                        : shape_of(s, hands_[static_cast<int>(hand)].gesture, height_);
}

bool Player::give(Hand hand, const Asked& asked) {
    const bool taken = clip_ || simulation_.strike(hand, asked.time, asked.shape);
    if (taken) last_impact_ = std::max(last_impact_, asked.time);
    return taken;
}

void Player::advance() {
    given_.clear();
    if (!playing_) return;
    if (wished_leading_ != leading_) change_over();
    for (const Hand hand : kHands) advance(hand);
    if (!over()) return;
    playing_ = false;
    if (clip_) simulation_.follow_strokes();
}

bool Player::over() const {
    const bool given = std::all_of(kHands.begin(), kHands.end(), [&](Hand hand) {
        const HandState& h = hands_[static_cast<int>(hand)];
        return h.next == h.strokes.size() && !busy(hand);
    });
    return given && (!clip_ || tempo_.position(simulation_.frontier()) >=
                                   clip_->follower().clip().duration() + kAtRest);
}

void Player::advance(Hand hand) {
    HandState& h = state(hand);
    while (h.next < h.strokes.size() && !busy(hand)) {
        Asked asked;
        asked.stroke = h.strokes[h.next++];
        asked.time = impact_time(asked.stroke);
        shape(hand, asked);
        if (!give(hand, asked)) {
            ++dropped_;
            continue;
        }
        ++asked_;
        h.recent.push_back(asked);
        given_.push_back(asked);
        if (h.recent.size() > kRemembered) h.recent.pop_front();
    }
}

/// Whether `from` could play what is left for `to` without striking again too soon.
bool Player::can_take_over(const HandState& from, const HandState& to) const {
    if (from.recent.empty() || to.next == to.strokes.size()) return true;
    return impact_time(to.strokes[to.next]) - from.recent.back().time > kSoonest;
}

void Player::change_over() {
    auto& [left, right] = hands_;
    if (!can_take_over(left, right) || !can_take_over(right, left)) return;
    std::swap(left.strokes, right.strokes);
    std::swap(left.next, right.next);
    leading_ = wished_leading_;
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
