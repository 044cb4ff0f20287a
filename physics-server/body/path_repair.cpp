#include "body/path_repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percussionist::body {

namespace {

using linear::Vector3;
using motion::TrajectorySample;
using Samples = std::vector<TrajectorySample>;

/// A path that stays elsewhere for so long is there [s].
constexpr double kBelieved = 0.12;
/// The tolerance: its floor [m], its share of the noise, and of what a tip is accelerated by while
/// it swings [m/s^2].
constexpr double kFloor = 0.002;
constexpr double kOfNoise = 10.0;
constexpr double kSwing = 120.0;

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
    const Vector3 along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - a - share * along).norm();
}

Vector3 velocity(const TrajectorySample& a, const TrajectorySample& b) {
    return (b.position - a.position) / (b.time - a.time);
}

/// Where the straight line from p to q is at `time`.
Vector3 chord(const TrajectorySample& p, const TrajectorySample& q, double time) {
    return p.position + (time - p.time) * velocity(p, q);
}

class PathMender {
  public:
    PathMender(const Samples& samples, double noise) : s_(samples), noise_(noise) {}

    /// The samples without glitches, in their order.
    Samples mend() {
        std::size_t next = 0;
        while (next < s_.size()) {
            const std::size_t bad = glitch_at(next);
            if (bad == 0) good_.push_back(s_[next]);
            next += std::max<std::size_t>(bad, 1);
        }
        return std::move(good_);
    }

  private:
    [[nodiscard]] double tolerance(double dt) const {
        return kFloor + kOfNoise * noise_ + kSwing * dt * dt;
    }

    /// How far the step from p to q is from all mixtures of the velocities before and after [m].
    static double jump(const TrajectorySample& p, const TrajectorySample& q, const Vector3& before,
                       const Vector3& after) {
        const double dt = q.time - p.time;
        return distance_to_segment(q.position - p.position, dt * before, dt * after);
    }

    /// Whether no turn that a stick makes leads there.
    [[nodiscard]] bool unreachable(const TrajectorySample& last, const TrajectorySample& s,
                                   const Vector3& before) const {
        constexpr double kHardestTurn = 30.0;  // [m/s]
        const double dt = s.time - last.time;
        return (s.position - last.position - dt * before).norm() >
               kHardestTurn * dt + tolerance(dt);
    }

    /// How many samples from `a` on are a glitch; 0: none.
    [[nodiscard]] std::size_t glitch_at(std::size_t a) const {
        if (good_.size() < 2) return 0;
        const TrajectorySample& last = good_.back();
        const Vector3 before = velocity(good_[good_.size() - 2], last);
        for (std::size_t b = a + 1; b <= s_.size(); ++b) {
            if (s_[b - 1].time - last.time > kBelieved) return 0;
            if (b - a >= 2) {
                const Vector3 inside = velocity(s_[a], s_[a + 1]);
                if (jump(last, s_[a], before, inside) <= tolerance(s_[a].time - last.time))
                    return 0;
            }
            // A jump after which nothing more comes is no motion either.
            if (b == s_.size()) return b - a >= 2 || unreachable(last, s_[a], before) ? b - a : 0;
            if (b + 1 < s_.size() && is_glitch(a, b, before)) return b - a;
        }
        return 0;
    }

    [[nodiscard]] bool is_glitch(std::size_t a, std::size_t b, const Vector3& before) const {
        const TrajectorySample& last = good_.back();
        const Vector3 after = velocity(s_[b], s_[b + 1]);
        if (b - a >= 2) {
            const Vector3 inside = velocity(s_[b - 2], s_[b - 1]);
            const double dt = s_[b].time - s_[b - 1].time;
            if (jump(s_[b - 1], s_[b], inside, after) <= tolerance(dt)) return false;
        }
        const std::size_t end = b - 1;
        const Vector3 on = last.position + (s_[a].time - last.time) * before;
        const Vector3 back = s_[b].position - (s_[b].time - s_[end].time) * after;
        const Vector3 in = chord(last, s_[b], s_[a].time);
        const Vector3 out = chord(last, s_[b], s_[end].time);
        double off = std::min(distance_to_segment(s_[a].position, on, in),
                              distance_to_segment(s_[end].position, back, out));
        if (a == end) off = std::min(off, distance_to_segment(s_[a].position, on, back));
        return off > tolerance(std::min(s_[a].time - last.time, s_[b].time - s_[end].time));
    }

    const Samples& s_;
    double noise_;
    Samples good_;
};

void turn_round(Samples& samples) {
    std::reverse(samples.begin(), samples.end());
    for (TrajectorySample& sample : samples) sample.time = -sample.time;
}

}  // namespace

double path_noise(const motion::Trajectory& path) {
    const Samples& s = path.samples;
    std::vector<double> thirds;
    for (std::size_t i = 3; i < s.size(); ++i) {
        const Vector3 d =
            s[i].position - 3.0 * s[i - 1].position + 3.0 * s[i - 2].position - s[i - 3].position;
        thirds.push_back(d.norm());
    }
    if (thirds.empty()) return 0.0;
    const auto middle = thirds.begin() + static_cast<std::ptrdiff_t>(thirds.size() / 2);
    std::nth_element(thirds.begin(), middle, thirds.end());
    // Of white noise the third difference is sqrt(20) times as large on each axis; the median
    // length of three such is 1.54 of one.
    constexpr double kOfOneAxis = 4.472 * 1.54;
    return *middle / kOfOneAxis;
}

Repairs repair(motion::Trajectory& path) {
    const std::size_t before = path.samples.size();
    const double noise = path_noise(path);
    // Forwards, and backwards for a path that begins with a glitch.
    for (int way = 0; way < 2; ++way) {
        path.samples = PathMender(path.samples, noise).mend();
        turn_round(path.samples);
    }
    Repairs repairs;
    repairs.bridged = static_cast<int>(before - path.samples.size());
    return repairs;
}

}  // namespace percussionist::body
