#include "body/key_frames.hpp"

#include <algorithm>
#include <cmath>

namespace percussionist::body {

namespace {

using score::KitStroke;
using score::Limb;

constexpr double kTravelRise = 0.4;    // of UP, from object to object
constexpr double kLeastLift = 0.15;    // of UP, where there is hardly time
constexpr double kSoftest = 0.06;      // of UP, before the softest note of a hand
constexpr double kSoftestFoot = 0.25;  // and of a foot
constexpr double kHighest = 1.3;       // of UP, above what is far below
constexpr double kLiftPart = 0.28;     // of the time there is, for up and for down
constexpr double kLeastPart = 0.12;    // and at least, when far is to go
constexpr double kTopSpeed = 15.0;     // across [m/s]
constexpr double kPeakOverMean = 1.5;
constexpr double kTimeToClimb = 0.25;  // [s]
constexpr double kHigher = 0.15;       // of UP, in each try to get over what lies between
constexpr double kClimbSpeed = 1.5;    // up and down, for that [m/s]
constexpr double kClear = 0.02;        // between tip and faces [m]
constexpr int kLooks = 12;             // on the way
constexpr double kTurn = 0.08;         // from after one stroke to before the next [s]
constexpr double kLongPause = 1.6;     // between two strokes [s]
constexpr double kHalfWay = 0.55;      // of the way to rest, in time
constexpr double kToRest = 0.5;        // [s]
constexpr double kLeast = 0.15;        // share of a gap on either side of a merged key frame

/// Lays key frames in order of time.
class Track {
  public:
    Track(const KitPoses& poses, const score::Kit& kit, Limb limb)
        : poses_(poses), kit_(kit), limb_(limb), times_(times_of(limb)) {}

    std::vector<KeyFrame> lay(std::span<const KitStroke> strokes) {
        if (strokes.empty()) return {{0.0, KeyKind::rest, poses_.rest(limb_)}};
        arise(strokes.front().time - times_.fall);
        add(strokes.front().time - times_.fall, KeyKind::before, before(strokes.front()));
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            contact(strokes[i]);
            if (i + 1 < strokes.size()) join(strokes[i], strokes[i + 1]);
        }
        const double end = strokes.back().time + times_.held + times_.rise;
        add(end, KeyKind::after, leaving(strokes.back()));
        sink(end);
        return std::move(keys_);
    }

  private:
    [[nodiscard]] const StrikePoses& of(const KitStroke& s) const {
        return *poses_.of(limb_, s.event);
    }
    [[nodiscard]] LimbPose raised(const KitStroke& s, double share) const {
        return blend(of(s).down, of(s).up, share);
    }
    [[nodiscard]] double bounce(const KitStroke& s) const {
        return s.velocity * kit_.events[s.event].elasticity;
    }
    [[nodiscard]] bool same_object(const KitStroke& a, const KitStroke& b) const {
        return kit_.events[a.event].object == kit_.events[b.event].object;
    }
    [[nodiscard]] double raise(const KitStroke& s) const {
        return std::max(s.velocity, score::is_hand(limb_) ? kSoftest : kSoftestFoot);
    }
    [[nodiscard]] LimbPose before(const KitStroke& s) const { return raised(s, raise(s)); }
    [[nodiscard]] LimbPose after(const KitStroke& s) const { return raised(s, bounce(s)); }

    void add(double time, KeyKind kind, LimbPose pose) {
        keys_.push_back({time, kind, std::move(pose)});
    }
    void wait(double time) { add(time, KeyKind::rest, poses_.rest(limb_)); }
    /// To where the limb waits, from above.
    void sink(double from) {
        add(from + kHalfWay * kToRest, KeyKind::rest, poses_.above_rest(limb_));
        wait(from + kToRest);
    }
    /// The other way.
    void arise(double until) {
        wait(until - kToRest);
        add(until - kHalfWay * kToRest, KeyKind::rest, poses_.above_rest(limb_));
    }
    /// What a pause follows is left by some height.
    [[nodiscard]] LimbPose leaving(const KitStroke& s) const {
        return raised(s, std::max(bounce(s), kLeastLift));
    }
    void contact(const KitStroke& s) {
        add(s.time, KeyKind::contact, of(s).down);
        add(s.time + times_.held, KeyKind::release, of(s).down);
    }

    void join(const KitStroke& a, const KitStroke& b) {
        const double from = a.time + times_.held;
        const double gap = b.time - from;
        if (same_object(a, b) && gap < times_.rise + times_.fall + kTurn) {
            merge(a, b, from, gap);
        } else if (!same_object(a, b) && gap < kLongPause) {
            travel(a, b, from, gap);
        } else if (gap < kLongPause) {
            add(from + times_.rise, KeyKind::after, after(a));
            add(b.time - times_.fall, KeyKind::before, before(b));
        } else {
            add(from + times_.rise, KeyKind::after, leaving(a));
            sink(from + times_.rise);
            arise(b.time - times_.fall);
            add(b.time - times_.fall, KeyKind::before, before(b));
        }
    }

    /// Where the line that rises from a crosses the one that falls to b.
    void merge(const KitStroke& a, const KitStroke& b, double from, double gap) {
        const double up = bounce(a) / times_.rise;
        const double down = raise(b) / times_.fall;
        const double at = std::clamp(gap * down / (up + down), kLeast * gap, (1 - kLeast) * gap);
        const double height = std::min(down * (gap - at), std::max(bounce(a), raise(b)));
        add(from + at, KeyKind::merged, blend(raised(a, height), raised(b, height), 0.5));
    }

    /// Off the one object, across at the height of the higher, and down to the other; the less
    /// time, the lower and the sooner.
    void travel(const KitStroke& a, const KitStroke& b, double from, double gap) {
        const Vector3 way = spot_of(kit_, b.event, limb_) - spot_of(kit_, a.event, limb_);
        const double across = kPeakOverMean * way.norm() / (kTopSpeed * gap);
        const double part = std::clamp(0.5 * (1.0 - across), kLeastPart, kLiftPart);
        const double up = std::min(times_.rise, part * gap);
        const double down = std::min(times_.fall, part * gap);
        const double climb = way.z() / kit_.drummer.rise * std::min(1.0, gap / kTimeToClimb);
        const double lift = std::max(bounce(a), kTravelRise) * up / times_.rise;
        const double drop = std::max(raise(b), kTravelRise) * down / times_.fall;
        LimbPose off = raised(a, height(lift, climb));
        LimbPose to = raised(b, height(drop, -climb));
        const double most = kClimbSpeed * std::min(up, down) / kit_.drummer.rise;
        for (double more = kHigher; more <= most && !clears(off, to); more += kHigher) {
            off = raised(a, std::min(height(lift, climb) + more, kHighest));
            to = raised(b, std::min(height(drop, -climb) + more, kHighest));
        }
        add(from + up, KeyKind::after, std::move(off));
        add(b.time - down, KeyKind::before, std::move(to));
    }
    /// Whether the tip, on its way from pose to pose, keeps off all faces and shells.
    [[nodiscard]] bool clears(const LimbPose& from, const LimbPose& to) const {
        for (int i = 1; i < kLooks; ++i) {
            const Vector3 tip = poses_.tip(limb_, blend(from, to, static_cast<double>(i) / kLooks));
            if (std::any_of(kit_.objects.begin(), kit_.objects.end(),
                            [&](const score::KitObject& o) { return brushes(o, tip); })) {
                return false;
            }
        }
        return true;
    }
    static bool brushes(const score::KitObject& object, const Vector3& tip) {
        const Vector3 there = object.orientation().conjugate() * (tip - object.middle);
        return std::hypot(there.x(), there.y()) < object.radius + kClear && there.z() < kClear &&
               there.z() > -std::max(object.depth, kClear);
    }
    static double height(double lift, double climb) {
        return std::min(std::max(lift, kLeastLift) + std::max(climb, 0.0), kHighest);
    }

    const KitPoses& poses_;
    const score::Kit& kit_;
    Limb limb_;
    StrokeTimes times_;
    std::vector<KeyFrame> keys_;
};

/// The hi-hat's foot: how far the pedal is let go.
class HatTrack {
  public:
    HatTrack(const KitPoses& poses, const score::Kit& kit, Limb foot)
        : poses_(poses), kit_(kit), foot_(foot), times_(times_of(foot)) {}

    std::vector<KeyFrame> lay(std::span<const KitStroke> strokes) {
        for (const KitStroke& s : strokes) {
            const score::KitEvent& event = kit_.events[s.event];
            if (s.limb == foot_) {
                press(s);
            } else if (event.hat == score::HatState::open) {
                open(s.time);
            } else if (event.hat == score::HatState::closed) {
                close(s.time - kReady);
            }
        }
        close(last_ + kStaysOpen);
        if (keys_.empty()) keys_.push_back({0.0, KeyKind::rest, poses_.rest(foot_)});
        return std::move(keys_);
    }

  private:
    static constexpr double kReady = 0.01;     ///< before the hand strikes [s]
    static constexpr double kMove = 0.08;      ///< [s]
    static constexpr double kStaysOpen = 1.2;  ///< if nothing comes [s]

    const StrikePoses* pressing() {
        for (std::size_t e = 0; e < kit_.events.size(); ++e) {
            if (poses_.of(foot_, e)) return &*poses_.of(foot_, e);
        }
        return nullptr;
    }

    void add(double time, KeyKind kind, double up) {
        const StrikePoses* const strike = pressing();
        if (strike == nullptr || time <= last_) return;
        keys_.push_back({time, kind, blend(strike->down, strike->up, up)});
        last_ = time;
    }

    void open(double time) {
        if (up_ == 0.0) {
            add(time - kReady - kMove, KeyKind::rest, 0.0);
            add(time - kReady, KeyKind::rest, score::kOpenHat);
        }
        up_ = score::kOpenHat;
        add(time, KeyKind::rest, score::kOpenHat);
    }

    /// Silently, at most so late.
    void close(double time) {
        if (up_ == 0.0 || time <= last_) return;
        const double at = std::min(time, last_ + kStaysOpen);
        add(at - kMove, KeyKind::rest, up_);
        add(at, KeyKind::rest, 0.0);
        up_ = 0.0;
    }

    /// Of a stroke at a time: waiting gives way to it.
    void make_room(double time) {
        while (!keys_.empty() && keys_.back().kind == KeyKind::rest &&
               keys_.back().time > time - kReady) {
            keys_.pop_back();
            last_ = keys_.empty() ? -1e9 : keys_.back().time;
        }
    }

    void press(const KitStroke& s) {
        if (up_ > 0.0 && s.time - last_ > kStaysOpen + times_.fall) close(s.time);
        make_room(s.time);
        const double gap = s.time - last_;
        const double up =
            std::max({up_, kSoftestFoot, std::min(s.velocity, 0.5 * gap / times_.fall)});
        if (gap > 2.0 * times_.fall) {
            add(s.time - 2.0 * times_.fall, KeyKind::rest, up_);
            add(s.time - times_.fall, KeyKind::before, up);
        } else {
            add(s.time - 0.5 * gap, KeyKind::merged, up);
        }
        add(s.time, KeyKind::contact, 0.0);
        add(s.time + times_.held, KeyKind::release, 0.0);
        up_ = 0.0;
    }

    const KitPoses& poses_;
    const score::Kit& kit_;
    Limb foot_;
    StrokeTimes times_;
    std::vector<KeyFrame> keys_;
    double last_ = -1e9;  ///< key frame's time [s]
    double up_ = 0.0;     ///< how far the pedal is let go
};

std::size_t phase_between(KeyKind from, KeyKind to) {
    if (to == KeyKind::contact) return static_cast<std::size_t>(score::Phase::down);
    if (from == KeyKind::release) return static_cast<std::size_t>(score::Phase::up);
    return static_cast<std::size_t>(score::Phase::between);
}

/// Where the kit has no script.
double usual(std::size_t phase, double u) {
    if (phase == static_cast<std::size_t>(score::Phase::down)) return u * u;
    if (phase == static_cast<std::size_t>(score::Phase::up)) return u * (2.0 - u);
    return u * u * (3.0 - 2.0 * u);
}

}  // namespace

StrokeTimes times_of(Limb limb) {
    if (score::is_hand(limb)) return {};
    return {.fall = 0.09, .rise = 0.12, .held = 0.005};
}

std::vector<KeyFrame> key_frames(const KitPoses& poses, const score::Kit& kit, Limb limb,
                                 std::span<const KitStroke> strokes) {
    return Track(poses, kit, limb).lay(strokes);
}

std::vector<KeyFrame> hat_key_frames(const KitPoses& poses, const score::Kit& kit, Limb foot,
                                     std::span<const KitStroke> strokes) {
    return HatTrack(poses, kit, foot).lay(strokes);
}

LimbPose blend(const LimbPose& a, const LimbPose& b, double share) {
    LimbPose pose = a;
    for (std::size_t j = 0; j < a.size(); ++j) {
        pose[j] =
            a[j] * linear::quaternion_exp(share * linear::quaternion_log(a[j].conjugate() * b[j]));
    }
    return pose;
}

double along(std::span<const double> curve, double u) {
    const auto parts = static_cast<double>(curve.size() - 1);
    const double place = std::clamp(u, 0.0, 1.0) * parts;
    const std::size_t i = std::min(static_cast<std::size_t>(place), curve.size() - 2);
    const double t = place - static_cast<double>(i);
    // Catmull and Rom's cubic; at its ends the slope of the part itself.
    const auto slope = [&](std::size_t k) {
        const std::size_t low = k == 0 ? 0 : k - 1;
        const std::size_t high = std::min(k + 1, curve.size() - 1);
        return (curve[high] - curve[low]) / static_cast<double>(high - low);
    };
    const double a = curve[i], b = curve[i + 1], da = slope(i), db = slope(i + 1);
    return a + t * (da + t * (3 * (b - a) - 2 * da - db + t * (2 * (a - b) + da + db)));
}

LimbMotion::LimbMotion(const Skeleton& skeleton, const score::Kit& kit, const LimbParts& parts,
                       std::vector<KeyFrame> keys)
    : parts_(parts), keys_(std::move(keys)) {
    for (auto& phase : scripts_) phase.resize(parts.segments.size());
    for (const score::Script& script : kit.scripts) {
        for (std::size_t j = 0; j < parts.segments.size(); ++j) {
            const std::string& joint = skeleton.segments[parts.segments[j]].joint;
            if (joint.substr(joint.find('_') + 1) != script.joint) continue;
            scripts_[static_cast<std::size_t>(script.phase)][j] = script.curve;
        }
    }
}

void LimbMotion::at(double t, Posture& posture) const {
    const auto next =
        std::upper_bound(keys_.begin(), keys_.end(), t,
                         [](double time, const KeyFrame& k) { return time < k.time; });
    const KeyFrame& to = next == keys_.end() ? keys_.back() : *next;
    const KeyFrame& from = next == keys_.begin() ? to : *(next - 1);
    const double length = to.time - from.time;
    const double u = length > 0.0 ? std::clamp((t - from.time) / length, 0.0, 1.0) : 0.0;
    const std::size_t phase = phase_between(from.kind, to.kind);
    for (std::size_t j = 0; j < parts_.segments.size(); ++j) {
        const std::vector<double>& curve = scripts_[phase][j];
        const double share = curve.empty() ? usual(phase, u) : along(curve, u);
        const Vector3 way = linear::quaternion_log(from.pose[j].conjugate() * to.pose[j]);
        posture.joints[parts_.segments[j]] = from.pose[j] * linear::quaternion_exp(share * way);
    }
}

}  // namespace percussionist::body
