#include "core/motion/synthetic_stick.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percussionist::motion {

namespace {

double cubic(double t0, double p0, double m0, double t1, double p1, double m1, double t) {
    const double h = t1 - t0;
    const double s = (t - t0) / h;
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * p0 + (s3 - 2 * s2 + s) * h * m0 + (3 * s2 - 2 * s3) * p1 +
           (s3 - s2) * h * m1;
}

}  // namespace

SyntheticStick::SyntheticStick(const SyntheticStickSettings& settings,
                               std::vector<SyntheticStroke> strokes)
    : settings_(settings) {
    for (SyntheticStroke& stroke : strokes) {
        // From rest to rest over h metres in 2 h / v, a cubic's acceleration is up to 3 v^2 / 2 h.
        const double height = settings.apex - settings.tip_radius - stroke.miss;
        stroke.velocity =
            stroke.miss > 0
                ? std::min(stroke.velocity, std::sqrt(2 * height * settings.hardest_stop / 3))
                : stroke.velocity;
    }
    heights_ = {heights_of(0, strokes), heights_of(1, strokes)};
    for (const SyntheticStroke& stroke : strokes) {
        const double tilt = at(heights_[0], stroke.time) - at(heights_[1], stroke.time);
        const double reach = std::sqrt(
            std::max(0.0, settings_.half_length * settings_.half_length - 0.25 * tilt * tilt));
        const double along = stroke.end == 0 ? reach : -reach;
        middle_[0].push_back({stroke.time, stroke.r * std::cos(stroke.theta), 0.0});
        middle_[1].push_back({stroke.time, stroke.r * std::sin(stroke.theta) - along, 0.0});
    }
}

Vector3 SyntheticStick::tip(int end) const {
    return {end == 0 ? settings_.half_length : -settings_.half_length, 0.0, 0.0};
}

double SyntheticStick::turning_time(const SyntheticStroke& stroke) const {
    // Where the cubic from 0 with slope -v to 0 with slope e v has none.
    const double e = settings_.rebound;
    const double a = 3 * (e - 1), b = 4 - 2 * e;
    const double s = std::abs(a) < 1e-9 ? 1 / b : (-b + std::sqrt(b * b + 4 * a)) / (2 * a);
    return stroke.time + s * settings_.contact;
}

/// Up from a stroke, and down so as to be at `next_low` with the next velocity at the next time.
void SyntheticStick::add_swing(Path& path, const SyntheticStroke& stroke, double next_time,
                               double next_velocity, double next_low) const {
    const double low = settings_.tip_radius + stroke.miss;
    const double up_rate = settings_.rebound * stroke.velocity;
    const double start = stroke.time + (stroke.miss > 0 ? 0.0 : settings_.contact);
    // A height takes this long to fall from, each metre of it [s/m]; a hurried hand rises as long.
    const double down = 2 * settings_.swing / next_velocity;
    const double room = next_time - start;
    const double apex = std::max(std::min(settings_.apex, next_low + 0.5 * room / down),
                                 std::max(low, next_low) + 1e-4);
    const double turn = next_time - (apex - next_low) * down;
    const double up = std::min(2 * settings_.swing * (apex - low) / up_rate, turn - start);
    path.push_back({start, low, stroke.miss > 0 ? 0.0 : up_rate});
    path.push_back({start + up, apex, 0.0});
    if (turn > path.back().time + 1e-6 && std::isfinite(turn)) {
        path.push_back({turn, apex, 0.0});
    }
}

SyntheticStick::Path SyntheticStick::heights_of(int end,
                                                const std::vector<SyntheticStroke>& strokes) const {
    std::vector<SyntheticStroke> own;
    std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(own),
                 [end](const SyntheticStroke& s) { return s.end == end; });
    Path path;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const SyntheticStroke& stroke = own[i];
        const double low = settings_.tip_radius + stroke.miss;
        if (i == 0) {
            const double down = 2 * settings_.swing / stroke.velocity;
            path.push_back({stroke.time - (settings_.apex - low) * down, settings_.apex, 0.0});
        }
        path.push_back({stroke.time, low, stroke.miss > 0 ? 0.0 : -stroke.velocity});
        if (stroke.miss > 0) {
            path.pop_back();  // add_swing() begins with this very knot
        }
        const bool last = i + 1 == own.size();
        add_swing(path, stroke, last ? std::numeric_limits<double>::infinity() : own[i + 1].time,
                  last ? 1.0 : own[i + 1].velocity,
                  settings_.tip_radius + (last ? 0.0 : own[i + 1].miss));
    }
    return path;
}

double SyntheticStick::at(const Path& path, double time) {
    const auto next = std::upper_bound(path.begin(), path.end(), time,
                                       [](double t, const Knot& knot) { return t < knot.time; });
    if (path.empty()) {
        return 0.06;
    }
    if (next == path.begin() || next == path.end()) {
        return next == path.begin() ? path.front().value : path.back().value;
    }
    const Knot& a = *(next - 1);
    return cubic(a.time, a.value, a.rate, next->time, next->value, next->rate, time);
}

Pose SyntheticStick::drum_from_stick(double time) const {
    const double z0 = at(heights_[0], time), z1 = at(heights_[1], time);
    const double sine = std::clamp((z0 - z1) / (2 * settings_.half_length), -0.95, 0.95);
    // x of the stick along y of the drum, end 0 raised by the tilt.
    const double cosine = std::sqrt(1 - sine * sine);
    linear::Matrix3 axes;
    axes.col(0) = Vector3(0, cosine, sine);
    axes.col(1) = Vector3(-1, 0, 0);
    axes.col(2) = axes.col(0).cross(axes.col(1));
    const Vector3 middle(at(middle_[0], time), at(middle_[1], time), 0.5 * (z0 + z1));
    return {middle, linear::Quaternion(axes)};
}

}  // namespace percussionist::motion
