#include "core/timing/clock_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace percussionist::timing {

namespace {

constexpr double kSurest = 2e-6;        // a rate is never known better from before than this
constexpr double kMemory = 32.0;        // blocks
constexpr double kCaution = 4.0;        // blocks
constexpr double kPatience = 0.35;      // [s]
constexpr unsigned kLeastSuspects = 4;  // observations

/// By so much the quickest way itself changes, as machines and networks are more or less busy.
constexpr double kWander = 2e-5;  // [s]

constexpr double kObservations = 200.0;  // that a mean goes back over
/// Before so many observations how late they usually are is not known; this much is thought usual.
constexpr unsigned kFewObservations = 32;
constexpr double kThoughtUsual = 0.1;  // [s]

/// The mean of `count` values, once `more` of them have been added that are `value`.
double running_mean(double mean, double value, double count, double most, double more = 1.0) {
    return mean + (value - mean) * std::min(1.0, more / std::min(count, most));
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
    if (y - block_.began >= settings_.block) {
        finish_block();
        block_.began = y;
    }
    const double late = y - to_y(x);
    if (late < -settings_.step || stepped_later(x, y, late)) {
        ++steps_;
        lock(x, y);
        return;
    }
    if (beginning_.count < kFewObservations) {
        beginning_.add(y - x - origin_);
    }
    if (suspect_.count == 0) {
        mean_late_ = running_mean(mean_late_, std::max(late, 0.0), ++observations_, kObservations);
    }
    if (block_.count++ == 0 || late < block_.late) {
        block_.least = {x - x0_, y - x - origin_};
        block_.late = late;
        if (late < 0.0) {
            fit();
        }
    }
}

/// What all of the observations in kPatience exceed once in e^16 times by chance, if their lateness
/// is even up to twice its mean: 16 times twice the mean by their number; and more where they are
/// not independent.
double ClockTracker::latest_usual() const noexcept {
    const double number = per_block_ * kPatience / settings_.block;
    const double unknown = observations_ < kFewObservations ? kThoughtUsual : 0.0;
    return std::max({settings_.step, 4.0 * least_late_, 32.0 * mean_late_ / number, unknown});
}

/// Whether for some time now nothing has come in time; then x and y become the least late of that.
bool ClockTracker::stepped_later(double& x, double& y, double late) noexcept {
    if (late <= latest_usual()) {
        acquit(y);
        return false;
    }
    if (suspect_.count++ == 0) {
        suspect_.began = y;
        suspect_.sum = 0.0;
    }
    suspect_.sum += late;
    if (suspect_.count == 1 || late < suspect_.late) {
        suspect_.late = late;
        suspect_.least = {x, y};
    }
    if (y - suspect_.began < kPatience || suspect_.count < kLeastSuspects) {
        return false;
    }
    x = suspect_.least.x;
    y = suspect_.least.y;
    return true;
}

/// The suspects were no more than late: that late is usual, then.
void ClockTracker::acquit(double y) noexcept {
    if (suspect_.count == 0) {
        return;
    }
    const double count = suspect_.count;
    observations_ += count;
    mean_late_ =
        running_mean(mean_late_, suspect_.sum / count, observations_, kObservations, count);
    if (y - suspect_.began > settings_.block) {
        least_late_ = running_mean(least_late_, suspect_.late, ++blocks_ + kCaution, kMemory);
    }
    suspect_ = {};
}

void ClockTracker::observe_if_early(double x, double y) noexcept {
    if (!started_ || y - to_y(x) < least_late_) {
        observe(x, y);
    }
}

void ClockTracker::lock(double x, double y) noexcept {
    if (count_ > 1) {
        const double span = points_[(first_ + count_ - 1) % kMostBlocks].x - points_[first_].x;
        known_error_ = std::clamp(slope_error(span), kSurest, known_error_);
        known_rate_ = rate_;
    }
    started_ = true;
    rate_error_ = known_error_;
    x0_ = x;
    origin_ = y - x;
    offset_ = 0.0;
    first_ = count_ = 0;
    suspect_ = {};
    beginning_ = {};
    beginning_.add(0.0);
    block_ = {.least = {0.0, 0.0}, .late = 0.0, .began = y, .count = 1};
}

/// Keeps the block's least late observation, unless it is much later than usual.
void ClockTracker::finish_block() noexcept {
    const Block done = std::exchange(block_, {});
    if (done.count == 0) {
        return;
    }
    if (done.late <= latest_usual()) {
        per_block_ = running_mean(per_block_, done.count, ++blocks_, kMemory);
        least_late_ =
            running_mean(least_late_, std::max(done.late, 0.0), blocks_ + kCaution, kMemory);
        keep(done.least);
        fit();
    }
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

/// By the single observations, or by the blocks once there are many: whichever tells more.
double ClockTracker::slope_error(double span) const noexcept {
    if (!(span > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const auto blocks = static_cast<double>(count_ + 1);
    const double single = 14.0 * lateness() / (per_block_ * blocks * span);
    const double chance =
        blocks < kMemory ? single : std::min(single, 8.0 * least_late_ / (blocks * span));
    return std::hypot(chance, kWander / span);
}

double ClockTracker::lateness() const noexcept {
    return beginning_.count < kFewObservations ? std::max(mean_late_, beginning_.lateness())
                                               : mean_late_;
}

double ClockTracker::uncertainty() const noexcept {
    const double number = per_block_ * static_cast<double>(count_) + block_.count;
    return 2.0 * lateness() / std::max(number, 1.0);
}

void ClockTracker::fit() noexcept {
    hull_count_ = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        add_to_hull(points_[(first_ + i) % kMostBlocks]);
    }
    if (block_.count > 0 && block_.late <= latest_usual()) {
        add_to_hull(block_.least);
    }
    if (hull_count_ == 0) {
        return;
    }
    const double error = slope_error(hull_[hull_count_ - 1].x - hull_[0].x);
    const double known = known_error_ * known_error_;
    const double trust = std::isfinite(error) ? known / (known + error * error) : 0.0;
    rate_error_ = known_error_ * std::sqrt(1.0 - trust);
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
