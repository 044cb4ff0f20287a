#include "core/motion/gesture_fit.hpp"

#include <array>
#include <cmath>

namespace percussionist::motion {

std::size_t GestureFit::in_window() const noexcept {
    std::size_t count = 1;
    while (count < poses_.size() &&
           (count < kLeast || poses_[0].time - poses_[count].time <= settings_.window + 1e-9)) {
        ++count;
    }
    return count;
}

Vector3 GestureFit::angular_velocity(std::size_t count, double middle) const noexcept {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < count; ++i) {
        const bool nearer =
            std::abs(poses_[i].time - middle) < std::abs(poses_[nearest].time - middle);
        nearest = nearer ? i : nearest;
    }
    const linear::Quaternion back = poses_[nearest].pose.orientation.conjugate();
    std::array<PathPoint, kMost> turns;
    for (std::size_t i = 0; i < count; ++i) {
        turns[i] = {poses_[i].time, linear::quaternion_log(poses_[i].pose.orientation * back)};
    }
    return LocalFit(std::span(turns).first(count), 2, middle).velocity(middle);
}

std::optional<Gesture> GestureFit::add(const TimedPose& pose) noexcept {
    if (poses_.size() > 0 && pose.time - poses_[0].time > settings_.longest_gap) {
        poses_.clear();
    }
    poses_.add(pose);
    if (poses_.size() < kLeast) {
        return std::nullopt;
    }
    const std::size_t count = in_window();
    const double middle = 0.5 * (poses_[0].time + poses_[count - 1].time);
    std::array<PathPoint, kMost> points;
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = {poses_[i].time, poses_[i].pose.position};
    }
    const LocalFit fit{std::span(points).first(count), 3, middle};
    Gesture g;
    g.time = middle;
    g.delay = poses_[0].time - middle;
    g.position = fit.position(middle);
    g.velocity = fit.velocity(middle);
    g.acceleration = fit.acceleration(middle);
    g.jerk = fit.jerk();
    g.speed = g.velocity.norm();
    if (g.speed >= settings_.least_speed) {
        g.direction = g.velocity / g.speed;
        g.turning = g.direction.cross(g.acceleration).norm() / g.speed;
        g.curvature = g.turning / g.speed;
    }
    g.angular_velocity = angular_velocity(count, middle);
    return g;
}

}  // namespace percussionist::motion
