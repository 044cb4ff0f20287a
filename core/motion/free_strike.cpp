#include "core/motion/free_strike.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::motion {

namespace {

constexpr std::size_t kOut = 4;        // points of the way out
constexpr std::size_t kIn = 5;         // points of the way in
constexpr std::size_t kMostGap = 8;    // points in between
constexpr double kElastic = 1.1;       // way out over way in, of a bounce without loss and ill seen
constexpr double kLongestStep = 0.02;  // [s] between points
constexpr double kLeastNoise = 2e-4;   // [m], where a fit is better than trackers are

/// Of the velocity at the end of a fit of n points, dt apart, with noise s each: about 4 s / (n
/// dt).
double velocity_uncertainty(double noise, double span) {
    return 4 * std::max(noise, kLeastNoise) / span;
}

}  // namespace

void FreeStrikeDetector::locate(FreeStrike& strike, const LocalFit& in, const LocalFit& out,
                                const Vector3& away, std::size_t gap) const noexcept {
    // From the last point of the way in to the first of the way out.
    const std::size_t first = kOut + gap, last = kOut - 1;
    const auto height = [&](std::size_t i) { return away.dot(points_[i].position); };
    std::size_t lowest = 1;  // the way out may begin before it has turned
    for (std::size_t i = 1; i <= first; ++i) {
        lowest = height(i) < height(lowest) ? i : lowest;
    }
    const double begin = points_[first].time, end = points_[last].time;
    // The ways in and out meet: v_in (t - begin) + h_in = v_out (t - end) + h_out.
    const double v_in = away.dot(in.velocity(begin)), v_out = away.dot(out.velocity(end));
    const double h_in = away.dot(in.position(begin)), h_out = away.dot(out.position(end));
    const double meet = (h_out - h_in + v_in * begin - v_out * end) / (v_in - v_out);
    if (gap == 0 && meet > begin && meet < end) {
        strike.time = meet;
    } else {
        const LocalFit bottom(std::array{points_[lowest + 1], points_[lowest], points_[lowest - 1]},
                              2, points_[lowest].time);
        const double slope = away.dot(bottom.velocity(points_[lowest].time));
        const double bend = away.dot(bottom.acceleration(points_[lowest].time));
        const double vertex = bend > 0.0 ? -slope / bend : 0.0;
        strike.time = std::clamp(points_[lowest].time + vertex, points_[lowest + 1].time,
                                 points_[lowest - 1].time);
    }
    double most = -1.0;
    for (std::size_t i = 1; i <= first; ++i) {
        const LocalFit bend(std::array{points_[i + 1], points_[i], points_[i - 1]}, 2,
                            points_[i].time);
        const double deceleration = away.dot(bend.acceleration(points_[i].time));
        if (deceleration > most) {
            most = deceleration;
            strike.peak_time = points_[i].time;
        }
    }
    strike.place = points_[lowest].position;
}

/// Whether the way in, `gap` points before the way out, and the way out do not belong together.
std::optional<FreeStrike> FreeStrikeDetector::judge(std::size_t gap, double noise) const noexcept {
    std::array<PathPoint, kOut> out_points;
    std::array<PathPoint, kIn> in_points;
    for (std::size_t i = 0; i < kOut; ++i) {
        out_points[i] = points_[i];
    }
    for (std::size_t i = 0; i < kIn; ++i) {
        in_points[i] = points_[kOut + gap + i];
    }
    const double in_end = in_points[0].time, out_begin = out_points[kOut - 1].time;
    const LocalFit in(in_points, 2, in_end), out(out_points, 2, out_begin);
    const Vector3 before = in.velocity(in_end), after = out.velocity(out_begin);
    const Vector3 way_out =
        (out_points[0].position - out_points[kOut - 1].position) / (out_points[0].time - out_begin);
    const double speed = before.norm();
    const Vector3 jump = after - before;
    if (out_begin - in_end > settings_.longest_contact || speed < settings_.least_speed ||
        std::max(after.dot(before), way_out.dot(before)) > (1 - settings_.turned) * speed * speed) {
        return std::nullopt;
    }
    const Vector3 away = jump.normalized();
    const double deceleration = jump.norm() / (out_begin - in_end);
    const double beside =
        std::max({0.0, away.dot(in.acceleration(in_end)), away.dot(out.acceleration(out_begin))});
    const double uncertain =
        velocity_uncertainty(std::max(noise, in.residual()), in_end - in_points[kIn - 1].time);
    if (deceleration < std::max(settings_.least_deceleration, settings_.sharpness * beside) ||
        way_out.norm() > kElastic * speed || after.norm() > kElastic * speed + 2 * uncertain ||
        is_swing_back(away, deceleration) || jump.norm() < settings_.certainty * uncertain) {
        return std::nullopt;
    }
    FreeStrike strike{.time = 0.0,
                      .peak_time = 0.0,
                      .speed = speed,
                      .deceleration = deceleration,
                      .direction = before / speed,
                      .place = Vector3::Zero()};
    locate(strike, in, out, away, gap);
    return strike;
}

/// The turn at the top of a swing, between two strikes the same way.
bool FreeStrikeDetector::is_swing_back(const Vector3& away, double deceleration) const noexcept {
    return points_[0].time < last_.time + settings_.swing && away.dot(-last_.direction) < -0.5 &&
           deceleration < last_.deceleration;
}

/// How far points lie from smooth ways, lately: strikes in between must not count, so what the
/// better third of the fits shows.
double FreeStrikeDetector::noise() noexcept {
    if (points_.size() < kIn) {
        return 0.0;
    }
    std::array<PathPoint, kIn> points;
    for (std::size_t i = 0; i < kIn; ++i) {
        points[i] = points_[i];
    }
    residuals_.add(LocalFit(points, 2, points[0].time).residual());
    std::array<double, 32> sorted{};
    for (std::size_t i = 0; i < residuals_.size(); ++i) {
        sorted[i] = residuals_[i];
    }
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(residuals_.size());
    const auto third = sorted.begin() + static_cast<std::ptrdiff_t>(residuals_.size() / 3);
    std::nth_element(sorted.begin(), third, end);
    return *third;
}

std::optional<FreeStrike> FreeStrikeDetector::add(const PathPoint& tip) noexcept {
    if (points_.size() > 0 && tip.time - points_[0].time > kLongestStep) {
        points_.clear();
    }
    points_.add(tip);
    const double lately = noise();
    std::optional<FreeStrike> sharpest;
    for (std::size_t gap = 0; gap <= kMostGap && kOut + gap + kIn <= points_.size(); ++gap) {
        const auto strike = judge(gap, lately);
        if (strike && (!sharpest || strike->deceleration > sharpest->deceleration)) {
            sharpest = strike;
        }
    }
    if (!sharpest || sharpest->time < last_.time + settings_.rest) {
        return std::nullopt;
    }
    last_ = *sharpest;
    return sharpest;
}

}  // namespace percussionist::motion
