#include "core/motion/plane_strike.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr std::size_t kFitted = 4;   // points of the approach
constexpr double kFittedSpan = 0.1;  // [s] that they span at most
constexpr double kSteady = 0.015;    // [s] before the strike, half its speed has to be there
constexpr double kSlowStep =
    0.015;  // [s] between points; beyond, one is not enough to tell a bounce
constexpr double kMisjudged = 0.25;   // of a step, that ways in and out are
constexpr double kLongestStep = 0.1;  // [s] between points; beyond, nothing is known

}  // namespace

void PlaneStrikeDetector::follow_side(const PathPoint& point) noexcept {
    const double z = point.position.z();
    const bool beyond = -side_ * z > settings_.tip_radius + settings_.clearance;
    if (!beyond) {
        beyond_since_.reset();
        return;
    }
    const double since = *(beyond_since_ = beyond_since_.value_or(point.time));
    if (point.time - since >= settings_.change_of_side || points_.size() == 1) {
        side_ = -side_;
        armed_ = false;
        beyond_since_.reset();
    }
}

void PlaneStrikeDetector::follow_clearance(const PathPoint& point) noexcept {
    armed_ = armed_ ||
             (distance(point) > settings_.clearance && point.time > last_strike_ + settings_.rest);
}

/// How many points up to and including `newest` come ever nearer to the plane, off the head.
std::size_t PlaneStrikeDetector::approach(std::size_t newest) const noexcept {
    std::size_t count = 0;
    for (std::size_t i = newest; i < points_.size() && count < kFitted; ++i) {
        const PathPoint& point = points_[i];
        const bool nearing = count == 0 || distance(point) > distance(points_[i - 1]);
        if (!nearing || distance(point) <= 0.0 || point.time <= last_strike_ ||
            points_[newest].time - point.time > kFittedSpan) {
            break;
        }
        ++count;
    }
    return count;
}

LocalFit PlaneStrikeDetector::fit_approach(std::size_t newest, std::size_t count) const noexcept {
    std::array<PathPoint, kFitted> points;
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = points_[newest + i];
    }
    return {std::span(points).first(count), 2, points_[newest].time};
}

/// When the fitted centre is one radius from the plane, from then on.
std::optional<double> PlaneStrikeDetector::meeting(const LocalFit& fit,
                                                   double from) const noexcept {
    const double d = side_ * fit.position(from).z() - settings_.tip_radius;
    const double v = side_ * fit.velocity(from).z();
    const double a = side_ * fit.acceleration(from).z();
    // d + v t + a t^2 / 2 = 0, the first root after now, in the form that does not cancel.
    const double root = v * v - 2 * a * d;
    if (d <= 0.0) {
        return from;
    }
    if (root < 0.0 || v >= 0.0) {
        return std::nullopt;
    }
    return from + 2 * d / (-v + std::sqrt(root));
}

std::optional<PlaneStrike> PlaneStrikeDetector::strike_at(const LocalFit& fit,
                                                          double time) noexcept {
    const Vector3 velocity = fit.velocity(time);
    const double speed = -side_ * velocity.z();
    const Place place = place_of(fit.position(time));
    const double steady = -side_ * fit.velocity(time - kSteady).z();
    if (std::min(speed, 2 * steady) < settings_.least_speed ||
        time < last_strike_ + settings_.rest ||
        (settings_.drum_radius > 0.0 && place.r > settings_.drum_radius)) {
        return std::nullopt;
    }
    armed_ = false;
    last_strike_ = time;
    return PlaneStrike{time, speed, velocity, place, side_ > 0 ? 1 : -1};
}

/// Between the point `newest` and the one after it: gone through, or turned back too early.
std::optional<PlaneStrike> PlaneStrikeDetector::strike_behind(std::size_t newest) noexcept {
    const PathPoint &before = points_[newest], &after = points_[newest - 1];
    const std::size_t count = approach(newest);
    if (count == 0 || after.time - before.time > kLongestStep) {
        return std::nullopt;
    }
    const LocalFit fit = fit_approach(newest, count);
    const auto meets = count > 1 ? meeting(fit, before.time) : std::nullopt;
    const double step = after.time - before.time;
    const bool slow = step >= kSlowStep;
    const double misjudged = newest == 2 ? kMisjudged * step : 0.0;
    const bool between = meets && *meets <= after.time + misjudged;
    if (newest == 2 && !between) {
        return std::nullopt;
    }
    if (distance(after) <= 0.0 && !between) {
        // It only came down after the last point of its approach: straight through the plane.
        const LocalFit line(std::array{before, after}, 1, before.time);
        const auto time = meeting(line, before.time);
        return time ? strike_at(line, *time) : std::nullopt;
    }
    if (!between) {
        return std::nullopt;
    }
    const bool struck = distance(after) <= settings_.clearance ||
                        (newest == 2 ? leaves_head(*meets, after, points_[0])
                                     : !slow && bounced(fit, *meets, before, after));
    return struck ? strike_at(fit, std::min(*meets, after.time)) : std::nullopt;
}

/// The way out tells what one record cannot: followed back it comes from the head, after the way in
/// has reached it.
bool PlaneStrikeDetector::leaves_head(double meets, const PathPoint& after,
                                      const PathPoint& next) const noexcept {
    const double speed = (distance(next) - distance(after)) / (next.time - after.time);
    const double misjudged = kMisjudged * (next.time - after.time);
    return speed > 0.0 && after.time - distance(after) / speed > meets - misjudged;
}

/// Whether it is where no hand could have brought it that only held the stick back, but a bounce,
/// which gives no more speed than it takes, could.
bool PlaneStrikeDetector::bounced(const LocalFit& fit, double meets, const PathPoint& before,
                                  const PathPoint& after) const noexcept {
    const double step = after.time - before.time;
    const double speed = -side_ * fit.velocity(before.time).z();
    const double stopping = std::min(step, speed / settings_.hardest_stop);
    const double held_back =
        distance(before) - speed * stopping + 0.5 * settings_.hardest_stop * stopping * stopping;
    const double thrown_back = -side_ * fit.velocity(meets).z() * (after.time - meets);
    return distance(after) > std::min(held_back + settings_.clearance, distance(before)) &&
           distance(after) < thrown_back + settings_.clearance;
}

std::optional<PlaneStrike> PlaneStrikeDetector::strike_ahead() noexcept {
    const std::size_t count = approach(0);
    if (count < 3) {
        return std::nullopt;
    }
    const LocalFit fit = fit_approach(0, count);
    const double now = points_[0].time;
    const auto time = meeting(fit, now);
    if (!time || *time > now + settings_.ahead) {
        return std::nullopt;
    }
    const double speed = -side_ * fit.velocity(now).z();
    const bool can_stop =
        speed * speed < 2 * settings_.hardest_stop * std::max(distance(points_[0]), 0.0);
    return can_stop ? std::nullopt : strike_at(fit, *time);
}

std::optional<PlaneStrike> PlaneStrikeDetector::add(const PathPoint& tip_drum) noexcept {
    points_.add(tip_drum);
    follow_side(tip_drum);
    std::optional<PlaneStrike> strike;
    if (armed_ && points_.size() > 1) {
        strike = strike_behind(1);
        if (!strike && points_.size() > 2) {
            strike = strike_behind(2);
        }
        strike = strike ? strike : strike_ahead();
    }
    follow_clearance(tip_drum);
    return strike;
}

}  // namespace percussionist::motion
