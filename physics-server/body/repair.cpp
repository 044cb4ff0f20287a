#include "body/repair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace percussionist::body {

namespace {

using linear::Quaternion;

constexpr double kFastestJoint = 60.0;  ///< [rad/s]
constexpr double kJump = 0.35;          ///< of a joint from its neighbours in time, a glitch [rad]
constexpr std::size_t kLongestRepeat = 5;

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

Repairs repair_rotations(std::vector<linear::Quaternion>& rotations, std::size_t joints,
                         double frame_time) {
    return JointMender(rotations, joints, frame_time).mend();
}

}  // namespace percussionist::body
