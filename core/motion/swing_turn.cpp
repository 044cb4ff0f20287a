#include "core/motion/swing_turn.hpp"

#include <array>
#include <cmath>
#include <span>

namespace percussionist::motion {

namespace {

constexpr double kLongestSwing = 0.4;            // [s]
constexpr double kNearly = 0.9;                  // of a span, as points are not even
constexpr double kBlunt = 0.035;                 // [s]
constexpr double kSharp = 0.03;                  // [s]
constexpr double kSure = 4.0, kSureBlunt = 8.0;  // of a deceleration over its uncertainty

}  // namespace

std::optional<std::size_t> SwingMeter::before(std::size_t from, double span) const noexcept {
    for (std::size_t i = from + 1; i < path_.size(); ++i) {
        if (path_[from].time - path_[i].time >= kNearly * span) {
            return i;
        }
    }
    return std::nullopt;
}

/// The newest point if none is late enough.
std::size_t SwingMeter::after(std::size_t from, double span) const noexcept {
    std::size_t i = 0;
    while (i + 1 < from && path_[i + 1].time - path_[from].time >= kNearly * span) {
        ++i;
    }
    return i;
}

std::size_t SwingMeter::start(std::size_t at, double& depth) const noexcept {
    const PathPoint& bottom = path_[at];
    std::size_t furthest = at;
    for (std::size_t i = at + 1;
         i < path_.size() && path_[i].time >= since_ && bottom.time - path_[i].time < kLongestSwing;
         ++i) {
        const double distance = (path_[i].position - bottom.position).norm();
        if (distance > depth) {
            depth = distance;
            furthest = i;
        } else if (distance < 0.8 * depth) {
            break;
        }
    }
    return furthest;
}

Vector3 SwingMeter::fastest(std::size_t at, std::size_t start, std::size_t& where) const noexcept {
    Vector3 result = Vector3::Zero();
    for (std::size_t i = at; i < start; ++i) {
        const auto j = before(i, 0.6 * kLag);
        if (!j || path_[*j].time < since_) {
            break;
        }
        const Vector3 velocity =
            (path_[i].position - path_[*j].position) / (path_[i].time - path_[*j].time);
        if (velocity.squaredNorm() > result.squaredNorm()) {
            result = velocity;
            where = i;
        }
    }
    return result;
}

bool SwingMeter::is_extreme(const SwingTurn& turn, std::size_t at) const noexcept {
    const auto first = before(at, kLag);
    for (std::size_t i = 0; first && i <= *first; ++i) {
        if (turn.retreat(path_[i].position) < -2.5 * noise_) {
            return false;
        }
    }
    return first.has_value();
}

void SwingMeter::decelerate(SwingTurn& turn, std::size_t at, std::size_t fastest,
                            double lag) const noexcept {
    const auto rate = [&](std::size_t from, std::size_t to) {
        return turn.direction.dot(path_[to].position - path_[from].position) /
               (path_[to].time - path_[from].time);
    };
    turn.deceleration = 0.0;
    double most = 0.0;
    for (std::size_t i = at; i <= fastest + 1; ++i) {
        const auto j = before(i, lag);
        const std::size_t k = after(i, lag);
        if (!j || k >= i || path_[*j].time < since_) {
            break;
        }
        const double in = rate(*j, i), out = rate(i, k);
        const double half = 0.5 * (path_[k].time - path_[*j].time);
        turn.deceleration = std::max(turn.deceleration, (in - std::max(out, 0.0)) / half);
        if ((in - out) / half > most) {
            most = (in - out) / half;
            turn.peak_time = path_[i].time;
        }
    }
}

std::optional<SwingTurn> SwingMeter::turn(std::size_t at) const noexcept {
    SwingTurn turn;
    turn.bottom = path_[at];
    std::size_t where = at;
    const Vector3 velocity = fastest(at, start(at, turn.depth), where);
    turn.speed = velocity.norm();
    if (turn.speed < 1e-6) {
        return std::nullopt;
    }
    turn.direction = velocity / turn.speed;
    if (!is_extreme(turn, at)) {
        return std::nullopt;
    }
    decelerate(turn, at, where, kLag);
    const double sure = turn.deceleration * kLag * kLag / (std::sqrt(6.0) * noise_);
    if (sure < kSure || (sure < kSureBlunt && turn.speed > kBlunt * turn.deceleration)) {
        decelerate(turn, at, where, 2 * kLag);
    }
    if (turn.deceleration < 1e-6) {
        return std::nullopt;
    }
    locate(turn);
    return turn;
}

/// Where straight ways in and out meet, if that is beside the furthest point.
std::optional<double> SwingMeter::meeting(const SwingTurn& turn, std::size_t at) const noexcept {
    constexpr std::size_t kMost = 8;
    std::array<PathPoint, kMost> before_it, after_it;
    std::size_t n_before = 0, n_after = 0;
    const double time = path_[at].time;
    for (std::size_t i = at + 1;
         i < path_.size() && n_before < kMost && time - path_[i].time < 1.1 * kLag; ++i) {
        before_it[n_before++] = path_[i];
    }
    for (std::size_t i = at; i-- > 0 && n_after < kMost && path_[i].time - time < 1.1 * kLag;) {
        after_it[n_after++] = path_[i];
    }
    if (n_before < 2 || n_after < 2) {
        return std::nullopt;
    }
    const LocalFit in(std::span<const PathPoint>(before_it.data(), n_before), 1, time);
    const LocalFit out(std::span<const PathPoint>(after_it.data(), n_after), 1, time);
    const double closing = turn.direction.dot(in.velocity(time) - out.velocity(time));
    const double apart = turn.direction.dot(out.position(time) - in.position(time));
    const double step = time - path_[at + 1].time;
    return closing > 0 && std::abs(apart) < step * closing ? std::optional(time + apart / closing)
                                                           : std::nullopt;
}

void SwingMeter::locate(SwingTurn& turn) const noexcept {
    const auto out = [&](std::size_t i) { return -turn.retreat(path_[i].position); };
    std::size_t at = 1;
    for (std::size_t i = 1; i + 1 < path_.size() && path_[i].time >= turn.bottom.time - kLag; ++i) {
        at = out(i) > out(at) ? i : at;
    }
    if (turn.lasts() < kSharp) {
        if (const auto time = meeting(turn, at)) {
            turn.time = *time;
            return;
        }
    }
    const double level = turn.level(noise_), edge = out(at) - level;
    std::size_t first = at, last = at;
    while (first + 1 < path_.size() && out(first + 1) > edge) {
        ++first;
    }
    while (last > 0 && out(last - 1) > edge) {
        --last;
    }
    turn.time = std::min(0.5 * (path_[first].time + path_[last].time),
                         path_[first].time + std::sqrt(2 * level / turn.deceleration));
}

}  // namespace percussionist::motion
