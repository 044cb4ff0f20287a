#include "core/timing/clock_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percussionist::timing {

namespace {

constexpr double kSurest = 2e-6;  // a rate is never known better from before than this

double running_mean(double mean, double value, double count, double most) {
    return mean + (value - mean) / std::min(count, most);
}

}  // namespace

double ClockTracker::to_x(double y) const noexcept {
    return x0_ + (y - x0_ - origin_ - offset_) / (1.0 + rate_);
}

void ClockTracker::restart() noexcept {
    started_ = false;
}

void ClockTracker::observe(double x, double y) noexcept {
    if (!started_) {
        lock(x, y);
        return;
    }
    const double late = y - to_y(x);
    if (late < -settings_.step) {
        ++steps_;
        lock(x, y);
        return;
    }
    if (std::abs(x - block_.began) >= settings_.block || std::abs(late) > 1.0) {
        finish_block();
        block_.began = x;
    }
    const double usual = std::max(settings_.step, 5.0 * std::max(mean_late_, least_late_));
    mean_late_ = running_mean(mean_late_, std::clamp(late, 0.0, usual), ++observations_, 200.0);
    if (block_.count++ == 0 || late < block_.late) {
        block_.least = {x - x0_, y - x - origin_};
        block_.late = late;
        if (late < 0.0) {
            fit();
        }
    }
}

void ClockTracker::lock(double x, double y) noexcept {
    if (count_ > 1) {
        const double span = points_[(first_ + count_ - 1) % kMostBlocks].x - points_[first_].x;
        known_error_ = std::clamp(slope_error(span), kSurest, known_error_);
        known_rate_ = rate_;
    }
    started_ = true;
    x0_ = x;
    origin_ = y - x;
    offset_ = 0.0;
    first_ = count_ = 0;
    suspect_ = {};
    block_ = {.least = {0.0, 0.0}, .late = 0.0, .began = x, .count = 1};
}

/// Keeps the block's least late observation, unless all of it came too late: then the clock has
/// perhaps been set, and surely if it was so in the block before.
void ClockTracker::finish_block() noexcept {
    const Block done = block_;
    block_ = {};
    if (done.count == 0) {
        return;
    }
    const double limit = std::max(settings_.step, 5.0 * least_late_);
    if (done.late > limit && suspect_.count > 0) {
        ++steps_;
        const Block before = suspect_;
        const double x0 = x0_, origin = origin_;
        lock(done.least.x + x0, done.least.y + done.least.x + origin + x0);
        block_ = {};
        keep({before.least.x + x0 - x0_, before.least.y + origin - origin_});
        keep({0.0, 0.0});
        fit();
        return;
    }
    per_block_ = running_mean(per_block_, done.count, ++blocks_, 32.0);
    least_late_ =
        running_mean(least_late_, std::clamp(done.late, 0.0, 2.0 * limit), blocks_ + 1.0, 32.0);
    suspect_ = {};
    if (done.late > limit) {
        suspect_ = done;
        return;
    }
    keep(done.least);
    fit();
}

void ClockTracker::keep(const Point& point) noexcept {
    for (const std::size_t wanted = blocks_wanted(); count_ >= wanted; --count_) {
        first_ = (first_ + 1) % kMostBlocks;
    }
    points_[(first_ + count_++) % kMostBlocks] = point;
}

/// The hull through `b` blocks is right to about three times a block's lateness by b.
std::size_t ClockTracker::blocks_wanted() const noexcept {
    const double wanted = 3.0 * least_late_ / settings_.accuracy;
    return static_cast<std::size_t>(
        std::clamp(wanted, static_cast<double>(kLeastBlocks), static_cast<double>(kMostBlocks)));
}

double ClockTracker::slope_error(double span) const noexcept {
    const double n = per_block_ * static_cast<double>(count_ + 1);
    return span > 0.0 ? 14.0 * mean_late_ / (n * span) : std::numeric_limits<double>::infinity();
}

void ClockTracker::fit() noexcept {
    hull_count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        add_to_hull(points_[(first_ + i) % kMostBlocks]);
    }
    if (block_.count > 0 && suspect_.count == 0) {
        add_to_hull(block_.least);
    }
    if (hull_count_ == 0) {
        return;
    }
    const double error = slope_error(hull_[hull_count_ - 1].x - hull_[0].x);
    const double known = known_error_ * known_error_;
    const double trust = std::isfinite(error) ? known / (known + error * error) : 0.0;
    rate_ = known_rate_ + (hull_count_ > 1 ? trust * (hull_slope() - known_rate_) : 0.0);
    rate_ = std::clamp(rate_, -settings_.max_rate, settings_.max_rate);
    offset_ = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < hull_count_; ++i) {
        offset_ = std::min(offset_, hull_[i].y - rate_ * hull_[i].x);
    }
}

/// Andrew's monotone chain; what comes out of order is left out.
void ClockTracker::add_to_hull(const Point& point) noexcept {
    if (hull_count_ > 0 && point.x <= hull_[hull_count_ - 1].x) {
        if (point.y >= hull_[hull_count_ - 1].y) {
            return;
        }
        --hull_count_;
    }
    while (hull_count_ > 1) {
        const Point& a = hull_[hull_count_ - 2];
        const Point& b = hull_[hull_count_ - 1];
        if ((b.x - a.x) * (point.y - a.y) > (b.y - a.y) * (point.x - a.x)) {
            break;
        }
        --hull_count_;
    }
    hull_[hull_count_++] = point;
}

double ClockTracker::hull_slope() const noexcept {
    const double middle = 0.5 * (hull_[0].x + hull_[hull_count_ - 1].x);
    std::size_t i = 1;
    while (i + 1 < hull_count_ && hull_[i].x < middle) {
        ++i;
    }
    return (hull_[i].y - hull_[i - 1].y) / (hull_[i].x - hull_[i - 1].x);
}

}  // namespace percussionist::timing
