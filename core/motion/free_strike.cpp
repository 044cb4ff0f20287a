#include "core/motion/free_strike.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr double kLongestStep = 0.04;  // [s] between points
constexpr double kLeastNoise = 1e-4;   // [m], where a fit is better than trackers are
constexpr double kStill = 0.06;        // [s]: blunter than this a turn has to have been there twice
constexpr double kAlike = 3.0;         // factor between turns that are alike
constexpr double kSameWay = 0.75;      // cosine
constexpr double kAgainst = -0.4;      // cosine
constexpr double kUsualVariance = 0.04;  // of -log lasts
constexpr double kFirstSharper = 0.3;    // where each way was seen once
constexpr double kFaster = 0.3;          // how much speed counts beside sharpness, as logarithms
constexpr double kStays = 1.4;  // a turn that does not come back at once counts as so much longer
constexpr double kSharpest = 0.015;  // [s]: shorter ones are all alike
constexpr int kMemory = 6;           // turns

}  // namespace

void FreeStrikeDetector::Way::add(const SwingTurn& turn, double new_sharpness) noexcept {
    count = std::min(count + 1, kMemory);
    const double off = new_sharpness - sharpness;
    sharpness += off / count;
    squares += count > 1 ? (off * off - squares) / count : 0.0;
    power += (turn.speed * turn.deceleration - power) / std::min(count, 4);
    log_speed += (std::log(turn.speed) - log_speed) / count;
}

double FreeStrikeDetector::Way::variance() const noexcept {
    return (2 * kUsualVariance + count * squares) / (count + 2);
}

void FreeStrikeDetector::reset() noexcept {
    path_.clear();
    pending_.reset();
}

/// How far points lie from smooth ways, lately: strikes in between must not count, so what the
/// better third of the fits shows.
void FreeStrikeDetector::update_noise() noexcept {
    constexpr std::size_t kFit = 5;
    if (path_.size() < kFit) {
        return;
    }
    std::array<PathPoint, kFit> points;
    for (std::size_t i = 0; i < kFit; ++i) {
        points[i] = path_[i];
    }
    residuals_.add(LocalFit(points, 2, points[0].time).residual());
    std::array<double, 32> sorted{};
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
        sorted[i] = residuals_[i];
    }
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(residuals_.size());
    const auto third = sorted.begin() + static_cast<std::ptrdiff_t>(residuals_.size() / 3);
    std::nth_element(sorted.begin(), third, end);
    noise_ = std::max(*third, kLeastNoise);
}

bool FreeStrikeDetector::stands_out(const SwingTurn& turn) const noexcept {
    return turn.speed > settings_.least_speed && turn.deceleration > settings_.least_deceleration &&
           turn.depth > 10 * noise_ && turn.time > struck_ + settings_.rest &&
           turn.lasts() < settings_.longest_turn;
}

bool FreeStrikeDetector::was_before(const SwingTurn& turn) const noexcept {
    const auto near = [](double a, double b) { return a < kAlike * b && b < kAlike * a; };
    int alike = 0;
    for (std::size_t i = 0; i < turns_.size(); ++i) {
        const SwingTurn& other = turns_[i];
        const double since = turn.time - other.time;
        alike += since > settings_.rest && since < settings_.memory &&
                         other.direction.dot(turn.direction) > kSameWay &&
                         near(other.speed, turn.speed) &&
                         near(other.deceleration, turn.deceleration)
                     ? 1
                     : 0;
    }
    return alike >= (turn.lasts() > kStill ? 2 : 1);
}

bool FreeStrikeDetector::is_other_way(const Way& own) const noexcept {
    const double scatter = std::sqrt((own.variance() + ways_[0].variance()) / own.count);
    const bool first = own.count == 1 && ways_[0].count == 1;
    const double faster = kFaster * (own.log_speed - ways_[0].log_speed);
    return own.sharpness + faster >
           ways_[0].sharpness + (first ? kFirstSharper : settings_.other_way + 2 * scatter);
}

bool FreeStrikeDetector::is_players(const SwingTurn& turn) noexcept {
    if (turns_.size() > 0 && turn.time > turns_[0].time + 3 * settings_.memory) {
        ways_ = {};
    }
    const bool against = ways_[0].count > 0 && turn.direction.dot(way_) < kAgainst;
    const bool stays = turn.retreat(path_[0].position) < settings_.returned * turn.depth;
    const double power = turn.speed * turn.deceleration;
    const double sharpness = -std::log(turn.lasts() * (stays ? kStays : 1.0));
    Way& own = ways_[against ? 1 : 0];
    if (!against && own.count > 0 &&
        (power < settings_.weak * own.power ||
         std::min(sharpness, -std::log(kSharpest)) < own.sharpness - std::log(settings_.dull))) {
        return false;
    }
    own.add(turn, std::min(sharpness, -std::log(kSharpest)));
    if (against && !is_other_way(own)) {
        return false;
    }
    if (against) {
        std::swap(ways_[0], ways_[1]);
    }
    way_ = turn.direction;
    return true;
}

std::optional<FreeStrike> FreeStrikeDetector::decide(const SwingTurn& turn) noexcept {
    const bool known = turn.lasts() < settings_.longest_stop || was_before(turn);
    const bool players = is_players(turn);
    turns_.add(turn);
    begun_ = turn.bottom.time;
    if (!known || !players) {
        return std::nullopt;
    }
    struck_ = turn.time;
    return FreeStrike{.time = turn.time,
                      .peak_time = turn.peak_time,
                      .speed = turn.speed,
                      .deceleration = turn.deceleration,
                      .direction = turn.direction,
                      .place = turn.bottom.position};
}

std::optional<FreeStrike> FreeStrikeDetector::wait() noexcept {
    const SwingTurn& turn = *pending_;
    const double retreat = turn.retreat(path_[0].position);
    if (retreat > std::max(4 * noise_, settings_.returned * turn.depth)) {
        SwingTurn back = turn;
        pending_.reset();
        meter().locate(back);
        return decide(back);
    }
    const bool goes_on = retreat < -std::max(3 * noise_, 0.02 * turn.depth);
    if (goes_on || path_[0].time > turn.time + settings_.patience) {
        pending_.reset();
    }
    return std::nullopt;
}

std::optional<FreeStrike> FreeStrikeDetector::judge(std::size_t at) noexcept {
    if (pending_) {
        const auto strike = wait();
        if (strike || pending_) {
            return strike;
        }
    }
    const auto turn = meter().turn(at);
    if (!turn || !stands_out(*turn)) {
        return std::nullopt;
    }
    if (turn->lasts() < settings_.longest_stop) {
        return decide(*turn);
    }
    pending_ = turn;
    return wait();
}

std::optional<FreeStrike> FreeStrikeDetector::add(const PathPoint& tip) noexcept {
    if (path_.size() > 0 && tip.time - path_[0].time > kLongestStep) {
        reset();
    }
    path_.add(tip);
    update_noise();
    const auto newest = meter().before(0, SwingMeter::kLag);
    if (!newest) {
        return std::nullopt;
    }
    // Each point is judged once, however many were lost since.
    std::size_t at = *newest;
    while (at + 1 < path_.size() && path_[at + 1].time > judged_) {
        ++at;
    }
    judged_ = path_[*newest].time;
    std::optional<FreeStrike> strike;
    for (std::size_t i = at + 1; i-- > *newest && !strike;) {
        strike = judge(i);
    }
    return strike;
}

}  // namespace percussionist::motion
