#include "body/repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percussionist::body {

namespace {

using linear::Quaternion;
using linear::Vector3;
using motion::TrajectorySample;

/// The fastest a stick's tip is believed to be [m/s], and what noise may add [m].
constexpr double kFastestTip = 15.0;
constexpr double kNoise = 0.004;
/// A path that stays elsewhere for so long is there [s].
constexpr double kBelieved = 0.12;
/// A single sample this far from the curve through its neighbours is a glitch [m/s times the time
/// between samples]: an impact at 5 m/s that throws the stick back at 3, the sharpest bend of a
/// path, is 2.7 m/s away from it.
constexpr double kSpike = 5.0;

constexpr double kFastestJoint = 60.0;  ///< [rad/s]
constexpr double kJump = 0.35;          ///< of a joint from its neighbours in time, a glitch [rad]
constexpr std::size_t kLongestRepeat = 5;

/// Where the samples around i have it at its time, by the cubic through four of them.
Vector3 expected(const std::vector<TrajectorySample>& s, std::size_t i) {
    Vector3 sum = Vector3::Zero();
    const std::size_t around[] = {i - 2, i - 1, i + 1, i + 2};
    for (const std::size_t j : around) {
        double weight = 1.0;
        for (const std::size_t k : around) {
            if (k != j) weight *= (s[i].time - s[k].time) / (s[j].time - s[k].time);
        }
        sum += weight * s[j].position;
    }
    return sum;
}

/// Marks samples that cannot be reached from the last good one.
void mark_jumps(const std::vector<TrajectorySample>& s, std::vector<bool>& bad) {
    const auto reachable = [&](std::size_t from, std::size_t to) {
        const double time = s[to].time - s[from].time;
        return (s[to].position - s[from].position).norm() <= kFastestTip * time + kNoise;
    };
    std::size_t good = 0;
    // A path may begin with a glitch: the first sample is believed if the second can be reached.
    while (good + 2 < s.size() && !reachable(good, good + 1) && !reachable(good, good + 2)) {
        bad[good++] = true;
    }
    for (std::size_t i = good + 1; i < s.size(); ++i) {
        if (reachable(good, i)) {
            good = i;
        } else if (s[i].time - s[good].time > kBelieved) {
            // It has moved there: what was left out since its arrival is taken back.
            std::size_t first = i;
            while (first > good + 1 && reachable(first - 1, first)) --first;
            for (std::size_t k = first; k <= i; ++k) bad[k] = false;
            good = i;
        } else {
            bad[i] = true;
        }
    }
}

void remove_marked(std::vector<TrajectorySample>& samples, const std::vector<bool>& bad) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!bad[i]) samples[kept++] = samples[i];
    }
    samples.resize(kept);
}

int count(const std::vector<bool>& bad) {
    return static_cast<int>(std::count(bad.begin(), bad.end(), true));
}

/// Marks single samples off the curve of their neighbours, the worst of each neighbourhood.
void mark_spikes(const std::vector<TrajectorySample>& s, std::vector<bool>& bad) {
    std::vector<double> off(s.size(), 0.0);
    for (std::size_t i = 2; i + 2 < s.size(); ++i) {
        off[i] = (s[i].position - expected(s, i)).norm();
    }
    for (std::size_t i = 2; i + 2 < s.size(); ++i) {
        const double most = std::max({off[i - 2], off[i - 1], off[i + 1], off[i + 2]});
        const double between = 0.5 * (s[i + 1].time - s[i - 1].time);
        if (off[i] > kSpike * between + kNoise && off[i] >= 1.2 * most) bad[i] = true;
    }
}

class JointMender {
  public:
    JointMender(std::vector<Quaternion>& rotations, std::size_t joints, double frame_time)
        : q_(rotations), joints_(joints), frame_time_(frame_time) {}

    Repairs mend() {
        leave_first();
        spread_repeats();
        for (std::size_t j = 0; j < joints_; ++j) {
            bridge_jumps(j);
            slow(j);
            join_signs(j);
        }
        return repairs_;
    }

  private:
    [[nodiscard]] std::size_t frames() const { return q_.size() / joints_; }
    Quaternion& at(std::size_t f, std::size_t j) { return q_[f * joints_ + j]; }

    void leave_first() {
        if (frames() < 3) return;
        double first = 0.0;
        double second = 0.0;
        for (std::size_t j = 0; j < joints_; ++j) {
            first = std::max(first, at(0, j).angularDistance(at(1, j)));
            second = std::max(second, at(1, j).angularDistance(at(2, j)));
        }
        if (first > kJump && first > 8.0 * second && first > kFastestJoint * frame_time_ / 4.0) {
            q_.erase(q_.begin(), q_.begin() + static_cast<std::ptrdiff_t>(joints_));
            repairs_.first_left = 1;
        }
    }

    bool repeats(std::size_t f) {
        for (std::size_t j = 0; j < joints_; ++j) {
            if (at(f, j).coeffs() != at(f - 1, j).coeffs()) return false;
        }
        return true;
    }

    void spread_repeats() {
        std::size_t f = 1;
        while (f < frames()) {
            std::size_t next = f;
            while (next < frames() && repeats(next)) ++next;
            const std::size_t run = next - f;
            if (run > 0 && run <= kLongestRepeat && next < frames()) {
                for (std::size_t k = 0; k < run; ++k, ++repairs_.repeated) {
                    const double share = static_cast<double>(k + 1) / static_cast<double>(run + 1);
                    for (std::size_t j = 0; j < joints_; ++j) {
                        at(f + k, j) = at(f - 1, j).slerp(share, at(next, j));
                    }
                }
            }
            f = next + 1;
        }
    }

    void bridge_jumps(std::size_t j) {
        for (std::size_t f = 1; f + 1 < frames(); ++f) {
            const Quaternion middle = at(f - 1, j).slerp(0.5, at(f + 1, j));
            const double off = middle.angularDistance(at(f, j));
            if (off > kJump && off > 2.0 * at(f - 1, j).angularDistance(at(f + 1, j))) {
                at(f, j) = middle;
                ++repairs_.bridged;
            }
        }
    }

    void slow(std::size_t j) {
        const double most = kFastestJoint * frame_time_;
        for (std::size_t f = 1; f < frames(); ++f) {
            const double turn = at(f - 1, j).angularDistance(at(f, j));
            if (turn <= most) continue;
            at(f, j) = at(f - 1, j).slerp(most / turn, at(f, j));
            ++repairs_.slowed;
        }
    }

    void join_signs(std::size_t j) {
        for (std::size_t f = 1; f < frames(); ++f) {
            if (at(f, j).dot(at(f - 1, j)) < 0.0) at(f, j).coeffs() *= -1.0;
        }
    }

    std::vector<Quaternion>& q_;
    std::size_t joints_;
    double frame_time_;
    Repairs repairs_;
};

}  // namespace

std::string Repairs::describe() const {
    const std::pair<int, const char*> kinds[] = {{bridged, "glitches bridged"},
                                                 {repeated, "repeated frames spread"},
                                                 {slowed, "too fast rotations slowed"},
                                                 {first_left, "first frame left out"}};
    std::string text;
    for (const auto& [n, what] : kinds) {
        if (n == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + what;
    }
    return text;
}

Repairs repair(motion::Trajectory& path) {
    Repairs repairs;
    for (const auto mark : {&mark_jumps, &mark_spikes}) {
        std::vector<bool> bad(path.samples.size(), false);
        mark(path.samples, bad);
        remove_marked(path.samples, bad);
        repairs.bridged += count(bad);
    }
    return repairs;
}

Repairs repair_rotations(std::vector<linear::Quaternion>& rotations, std::size_t joints,
                         double frame_time) {
    return JointMender(rotations, joints, frame_time).mend();
}

}  // namespace percussionist::body
