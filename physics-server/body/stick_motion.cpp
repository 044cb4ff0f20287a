#include "body/stick_motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body/clip_follower.hpp"
#include "body/joint_strength.hpp"
#include "body/path_repair.hpp"
#include "body/stroke_path.hpp"

namespace percussionist::body {

namespace {

/// Postures are found this often, or as often as positions were recorded [s].
constexpr double kPostureTime = 0.004;
/// Iterations of inverse kinematics to begin with, and from posture to posture.
constexpr int kSettling = 300;
constexpr double kNearest = 0.05;   // two strikes farther apart than this say where left is [m]
constexpr double kFarthest = 0.60;  // and nearer than this

double median_step(const motion::Trajectory& path) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < path.samples.size(); ++i) {
        steps.push_back(path.samples[i].time - path.samples[i - 1].time);
    }
    if (steps.empty()) return kPostureTime;
    std::nth_element(steps.begin(), steps.begin() + steps.size() / 2, steps.end());
    return steps[steps.size() / 2];
}

/// The middle of the lowest tenth, at the height of its lowest hundredth.
Vector3 strike_place(const motion::Trajectory& path) {
    std::vector<Vector3> all;
    for (const auto& sample : path.samples) all.push_back(sample.position);
    std::sort(all.begin(), all.end(),
              [](const Vector3& a, const Vector3& b) { return a.z() < b.z(); });
    const std::size_t low = std::max<std::size_t>(1, all.size() / 10);
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < low; ++i) sum += all[i] / static_cast<double>(low);
    sum.z() = all[all.size() / 100].z();
    return sum;
}

class StickMotionMaker {
  public:
    StickMotionMaker(const Skeleton& skeleton, const StickPlaces& places)
        : skeleton_(skeleton), kinematics_(skeleton, options()) {
        const double reach = skeleton.tip_rest(Hand::left).x();
        places_[0] = {reach, 0.5 * places.apart, places.height};
        places_[1] = {reach, -0.5 * places.apart, places.height};
    }

    StickMotion make(const std::string& name,
                     std::array<std::optional<motion::Trajectory>, 2>& paths) {
        for (const Hand hand : kHands) mend(paths[static_cast<int>(hand)]);
        if (motion_.frame_time == 0.0) throw std::invalid_argument(name + ": no path of a stick");
        align(paths);
        std::array<Spline, 2> tips{spline(paths[0], 0), spline(paths[1], 1)};
        find_postures(name, tips);
        return std::move(motion_);
    }

  private:
    static InverseKinematicsOptions options() {
        InverseKinematicsOptions o;
        o.iterations = 6;
        o.damping = 0.0005;
        return o;
    }

    void mend(std::optional<motion::Trajectory>& path) {
        if (!path) return;
        const Repairs repairs = repair(*path);
        if (path->samples.size() < 2) {
            throw std::invalid_argument(path->name +
                                        ": expected a path of a stick, got jumps alone");
        }
        const std::string what = repairs.describe();
        if (!what.empty()) motion_.remarks.push_back(path->name + ": " + what);
        motion_.frame_time = std::max(motion_.frame_time, median_step(*path));
        end_ = std::max(end_, path->samples.back().time);
    }

    void align(std::array<std::optional<motion::Trajectory>, 2>& paths) const {
        Quaternion turn = Quaternion::Identity();
        if (paths[0] && paths[1]) {
            Vector3 left = strike_place(*paths[0]) - strike_place(*paths[1]);
            left.z() = 0.0;
            if (left.norm() > kNearest && left.norm() < kFarthest) {
                turn =
                    Quaternion(Eigen::AngleAxisd(std::atan2(left.x(), left.y()), Vector3::UnitZ()));
            }
        }
        for (int h = 0; h < 2; ++h) {
            if (!paths[h]) continue;
            const Vector3 from = turn * strike_place(*paths[h]);
            for (auto& sample : paths[h]->samples) {
                sample.position = turn * sample.position - from + places_[h];
                sample.rotation = turn * sample.rotation;
            }
        }
    }

    [[nodiscard]] Spline spline(const std::optional<motion::Trajectory>& path, int h) const {
        constexpr double kWaiting = 0.10;  // above the place of its strike [m]
        std::vector<double> times;
        std::vector<double> values;
        const auto add = [&](double time, const Vector3& p) {
            times.push_back(time);
            for (const double c : {p.x(), p.y(), p.z()}) values.push_back(c);
        };
        if (path) {
            for (const auto& sample : path->samples) add(sample.time, sample.position);
        } else {
            add(0.0, places_[h] + kWaiting * Vector3::UnitZ());
        }
        return {std::move(times), std::move(values), 3};
    }

    void find_postures(const std::string& name, const std::array<Spline, 2>& tips) {
        const double dt = std::min(kPostureTime, motion_.frame_time);
        const auto count = static_cast<std::size_t>(std::ceil(end_ / dt)) + 1;
        const auto at = [&](double t) {
            ArmTargets targets;
            for (int h = 0; h < 2; ++h) {
                tips[h].at(std::min(t, tips[h].end()), std::span(targets[h].tip.data(), 3));
                // The hand goes with half of its tip's rise.
                const double above = targets[h].tip.z() - places_[h].z();
                targets[h].grip_height = places_[h].z() + kHandAbove + kHandShare * above;
            }
            return targets;
        };
        Posture posture(skeleton_);
        Placement placement(skeleton_);
        for (int i = 0; i < kSettling; ++i) kinematics_.solve(at(0.0), posture, placement);
        JointStrength strength(skeleton_, kinematics_.arms(), dt);
        std::vector<Posture> postures;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = static_cast<double>(i) * dt;
            const double off = kinematics_.solve(at(t), posture, placement);
            motion_.worst_reach = std::max(motion_.worst_reach, off);
            postures.push_back(posture);
            if (i == 0) strength.begin(posture, posture);
            if (strength.hold(postures[i])) {
                kinematics_.reach_by_hands(at(t), postures[i], placement);
            }
            for (Quaternion& q : postures.back().joints) {
                const std::size_t j = static_cast<std::size_t>(&q - postures.back().joints.data());
                if (i > 0 && q.dot(postures[i - 1].joints[j]) < 0.0) q.coeffs() *= -1.0;
            }
        }
        auto clip = std::make_shared<Clip>(name, skeleton_, postures, dt);
        clip->set_tips(tips);
        motion_.clip = std::move(clip);
    }

    static constexpr double kHandAbove = 0.035;  ///< the head, when the tip strikes [m]

    const Skeleton& skeleton_;
    InverseKinematics kinematics_;
    std::array<Vector3, 2> places_;
    StickMotion motion_;
    double end_ = 0.0;
};

}  // namespace

StickMotion follow_sticks(const std::string& name, const Skeleton& skeleton,
                          std::array<std::optional<motion::Trajectory>, 2> paths,
                          const StickPlaces& places) {
    return StickMotionMaker(skeleton, places).make(name, paths);
}

}  // namespace percussionist::body
