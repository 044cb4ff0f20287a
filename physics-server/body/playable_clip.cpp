#include "body/playable_clip.hpp"

#include <algorithm>
#include <cmath>

#include "body/stroke_path.hpp"
#include "core/listening/median.hpp"

namespace percussionist::body {

namespace {

/// Heights are looked at this often [s].
constexpr double kLook = 0.002;
/// Strokes of one hand are at least so far apart [s].
constexpr double kApart = 0.06;
/// How far below the touch a captured stroke turns: a head gives way by as much [m].
constexpr double kDip = 0.002;
/// Before its beginning and after its end a tip waits at least so far above the head [m].
constexpr double kClear = 0.08;

}  // namespace

void Lift::add(double time, double height) {
    points_.push_back({time, height});
}

double Lift::at(double t) const {
    if (points_.empty()) return 0.0;
    const auto next = std::upper_bound(points_.begin(), points_.end(), t,
                                       [](double time, const Point& p) { return time < p.time; });
    if (next == points_.begin()) return points_.front().height;
    if (next == points_.end()) return points_.back().height;
    const Point& last = *(next - 1);
    const double s = (t - last.time) / (next->time - last.time);
    return last.height + minimum_jerk(s) * (next->height - last.height);
}

PlayableClip::PlayableClip(std::shared_ptr<const Clip> clip, const Skeleton& skeleton)
    : skeleton_(skeleton),
      follower_(std::move(clip), skeleton_),
      posture_(skeleton_),
      placement_(skeleton_) {
    const std::array<Path, 2> paths{path_of(Hand::left), path_of(Hand::right)};
    if (paths[0].lows.empty() && paths[1].lows.empty()) return;
    find_place(paths);
    for (const Hand hand : kHands) bend(hand, paths[static_cast<int>(hand)]);
    std::sort(strokes_.begin(), strokes_.end(),
              [](const auto& a, const auto& b) { return a.touch < b.touch; });
}

Vector3 PlayableClip::tip(double t, Hand hand) const {
    if (!follower_.clip().has_own_tips()) follower_.posture(t, posture_, placement_);
    return follower_.tip(t, hand, placement_);
}

PlayableClip::Path PlayableClip::path_of(Hand hand) const {
    Path path;
    path.heights.dt = kLook;
    for (double t = 0.0; t <= follower_.clip().duration(); t += kLook) {
        path.heights.heights.push_back(tip(t, hand).z());
    }
    path.lows = body::find_strokes(path.heights, kApart);
    return path;
}

void PlayableClip::find_place(const std::array<Path, 2>& paths) {
    std::vector<double> lows;
    Vector3 places = Vector3::Zero();
    int hands = 0;
    for (const Hand hand : kHands) {
        const Path& path = paths[static_cast<int>(hand)];
        if (path.lows.empty()) continue;
        std::vector<double> x, y;
        for (const std::size_t low : path.lows) {
            const Vector3 there = tip(static_cast<double>(low) * kLook, hand);
            x.push_back(there.x());
            y.push_back(there.y());
            lows.push_back(there.z());
        }
        places += Vector3(listening::median(x), listening::median(y), 0.0);
        ++hands;
    }
    place_ = places / hands;
    place_.z() = listening::median(lows) + kDip;
}

void PlayableClip::bend(Hand hand, const Path& path) {
    Lift& lift = lifts_[static_cast<int>(hand)];
    const std::vector<double>& z = path.heights.heights;
    const auto lacks = [&](std::size_t low) { return place_.z() - kDip - z[low]; };
    // A motion glides on for a moment before it rests.
    const auto wait = [&](double time, double resting, double usual) {
        const double lowest = std::min(tip(time, hand).z(), tip(resting, hand).z());
        lift.add(time, std::max(usual, place_.z() + kClear - lowest));
    };
    const double end = follower_.clip().duration();
    const bool strikes = !path.lows.empty();
    wait(0.0, -1.0, strikes ? lacks(path.lows.front()) : 0.0);
    for (const std::size_t low : path.lows) {
        lift.add(static_cast<double>(low) * kLook, lacks(low));
        worst_lift_ = std::max(worst_lift_, std::abs(lacks(low)));
    }
    wait(end, end + 1.0, strikes ? lacks(path.lows.back()) : 0.0);
    const auto below = [&](std::size_t i) {
        return place_.z() - z[i] - lift.at(static_cast<double>(i) * kLook);
    };
    /// Where it passes the touch between two looks.
    const auto passes = [&](std::size_t i, std::size_t j) {
        const double share = below(i) / (below(i) - below(j));
        return kLook *
               (static_cast<double>(i) + share * (static_cast<double>(j) - static_cast<double>(i)));
    };
    for (const std::size_t low : path.lows) {
        std::size_t first = low, last = low;
        while (first > 0 && below(first) > 0.0) --first;
        while (last + 1 < z.size() && below(last) > 0.0) ++last;
        CapturedStroke stroke;
        stroke.hand = hand;
        stroke.touch = passes(first + 1, first);
        stroke.leave = passes(last - 1, last);
        stroke.shape = measure_stroke(path.heights, low);
        strokes_.push_back(stroke);
        in_head_[static_cast<int>(hand)].push_back({stroke.touch, stroke.leave});
    }
}

ArmTargets PlayableClip::targets(double t, Posture& rest) const {
    ArmTargets targets = follower_.targets(t, rest);
    for (int h = 0; h < 2; ++h) {
        const double lift = lifts_[h].at(t);
        targets[h].tip.z() += lift;
        targets[h].grip_height += kHandShare * lift;
    }
    return targets;
}

bool PlayableClip::in_head(double t, Hand hand) const {
    const auto& all = in_head_[static_cast<int>(hand)];
    const auto next = std::upper_bound(all.begin(), all.end(), t,
                                       [](double time, const auto& in) { return time < in[0]; });
    return next != all.begin() && t < (*(next - 1))[1];
}

}  // namespace percussionist::body
