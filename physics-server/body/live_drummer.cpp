#include "body/live_drummer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace percussionist::body {

namespace {

using score::Limb;

constexpr std::array<Limb, 4> kLimbs{Limb::left_hand, Limb::right_hand, Limb::left_foot,
                                     Limb::right_foot};
constexpr double kShortest = 0.040;     // from a note to its contact [s]
constexpr double kLongestWait = 0.350;  // [s]
constexpr double kGentle = 0.35;        // to the song's motion, if it has time [s]
constexpr double kRoomToLift = 0.09;    // before a contact [s]
constexpr double kLeastLift = 0.2;      // of UP
constexpr double kLingers = 0.6;        // above what was struck [s]
constexpr double kDearWait = 20.0;      // of the burden, a second's wait
constexpr double kDearCrossing = 4.0;
constexpr double kHatOpen = 0.8;     // of the pedal's way
constexpr double kHatReady = 0.005;  // before the hand strikes [s]
constexpr double kHatStays = 1.2;    // [s]
constexpr double kTogether = 1e-9;   // rounding, of times [s]
constexpr double kToReturn = 0.03;   // more than the way takes, to a stroke of the song [s]
constexpr double kShareOfReturn = 0.3;

/// With its reach noted.
score::Kit reached(score::Kit kit) {
    const Skeleton skeleton = make_drummer(kit.drummer);
    note_reach(KitPoses(skeleton, kit), kit);
    return kit;
}

}  // namespace

LiveDrummer::LiveDrummer(score::Kit kit)
    : kit_(reached(std::move(kit))),
      effort_(kit_),
      animation_(std::make_unique<KitAnimation>(kit_, strokes_)),
      kit_motion_(std::make_unique<KitMotion>(kit_, strokes_)),
      posture_(animation_->skeleton()),
      placement_(animation_->skeleton()) {
    build();
    move(0.0);
}

void LiveDrummer::load(std::vector<score::KitStroke> strokes) {
    auto animation = std::make_unique<KitAnimation>(kit_, strokes);
    animation_ = std::move(animation);
    strokes_ = std::move(strokes);
    build();
}

void LiveDrummer::build() {
    std::vector<LimbState> limbs;
    for (const Limb limb : kLimbs) {
        LimbState state{
            LiveLimb(skeleton(), kit_, animation_->poses().parts(limb)), {}, {}, now_, {}};
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            if (strokes_[i].limb == limb) state.strokes.push_back(i);
        }
        limbs.push_back(std::move(state));
    }
    limbs_ = std::move(limbs);
}

void LiveDrummer::step(double now, const score::SongStep& song) {
    contacts_.clear();
    song_ = song;
    if (song.jumped) {
        for (const Limb limb : kLimbs) {
            if (!of(limb).motion.performed()) settle(limb, now_);
        }
    } else {
        strike_song(now, song);
    }
    strike_coming(now);
    std::stable_sort(contacts_.begin(), contacts_.end(),
                     [](const KitContact& a, const KitContact& b) { return a.time < b.time; });
    for (const Limb limb : kLimbs) {
        if (of(limb).motion.over(now)) settle(limb, now);
    }
    for (const KitContact& c : contacts_) {
        of(c.limb).struck = {c.time, c.event};
        kit_motion_->strike({c.time, c.limb, c.event, c.velocity, 0, false, {}});
    }
    move(now);
    now_ = now;
}

/// Back to the song: in time for the first of its strokes that can be reached, or at leisure.
void LiveDrummer::settle(Limb limb, double now) {
    LimbState& state = of(limb);
    double within = kGentle;
    state.ready = now;
    for (auto next = next_in_song(limb); song_.rate > 0.0 && next != state.strokes.end(); ++next) {
        const double left = due(*next) - now;
        const double needed = std::max(
            kShortest, way(limb, strokes_[*next].event) / kit_.limits.speed + kit_.limits.settling);
        if (left < needed) continue;
        within = std::min(kGentle, left);
        state.ready = due(*next) - kit_.limits.settling;
        break;
    }
    state.motion.bend(within);
}

void LiveDrummer::strike_song(double now, const score::SongStep& song) {
    if (song.to <= song.from) return;
    for (const Limb limb : kLimbs) {
        LimbState& state = of(limb);
        const auto later = [this](double t, std::size_t i) { return t < strokes_[i].time; };
        const auto end =
            std::upper_bound(state.strokes.begin(), state.strokes.end(), song.to, later);
        auto next = std::upper_bound(state.strokes.begin(), end, song.from, later);
        for (; next != end; ++next) {
            const score::KitStroke& s = strokes_[*next];
            const double share = (s.time - song.from) / (song.to - song.from);
            const double time = now_ + share * (now - now_);
            if (state.motion.performed() || time < state.ready) {
                ++passed_over_;
            } else {
                add({time, limb, s.event, s.velocity, static_cast<int>(*next), false});
            }
        }
    }
}

void LiveDrummer::strike_coming(double now) {
    for (const Limb limb : kLimbs) {
        std::vector<KitContact>& coming = of(limb).coming;
        while (!coming.empty() && coming.front().time <= now) {
            contacts_.push_back(coming.front());
            coming.erase(coming.begin());
        }
    }
}

void LiveDrummer::add(const KitContact& contact) {
    contacts_.push_back(contact);
    Past& past = of(contact.limb).past;
    const bool again = past.any && contact.time - past.hit.time < kit_.limits.interval;
    past = {{contact.time, contact.velocity, 1.0, contact.event}, true, again && !past.bounced};
}

void LiveDrummer::move(double now) {
    animation_->trunk_at(song_.to, posture_);
    for (const Limb limb : kLimbs) {
        of(limb).motion.at(now, animation_->motion(limb), song_.to, posture_);
    }
    if (shown_) {
        const StrikePoses& poses = *animation_->poses().of(shown_->limb, shown_->event);
        const LimbPose& pose = shown_->up ? poses.up : poses.down;
        const std::vector<int>& segments = animation_->poses().parts(shown_->limb).segments;
        for (std::size_t j = 0; j < pose.size(); ++j) posture_.joints[segments[j]] = pose[j];
    }
    forward_kinematics(skeleton(), posture_, placement_);
    kit_motion_->at(now, skeleton(), placement_, objects_);
    kit_motion_->forget();
}

std::vector<std::size_t>::const_iterator LiveDrummer::next_in_song(Limb limb) const {
    const std::vector<std::size_t>& own = of(limb).strokes;
    return std::upper_bound(own.begin(), own.end(), song_.to,
                            [this](double t, std::size_t i) { return t < strokes_[i].time; });
}

/// When, as the song goes now.
double LiveDrummer::due(std::size_t stroke) const {
    return now_ + (strokes_[stroke].time - song_.to) / song_.rate;
}

/// The next stroke that its motion leads to; far off if there is none.
ForecastStroke LiveDrummer::coming(Limb limb) const {
    const LimbState& state = of(limb);
    const ForecastStroke none{1e9, state.struck.event};
    if (!state.coming.empty()) return {state.coming.front().time, state.coming.front().event};
    if (state.motion.performed() || song_.rate <= 0.0) return none;
    for (auto next = next_in_song(limb); next != state.strokes.end(); ++next) {
        if (due(*next) >= state.ready) return {due(*next), strokes_[*next].event};
    }
    return none;
}

LimbForecasts LiveDrummer::forecasts() const {
    LimbForecasts all;
    for (const Limb limb : kLimbs) all[index(limb)] = {of(limb).struck, coming(limb)};
    return all;
}

/// From where it is [m].
double LiveDrummer::way(Limb limb, std::size_t event) const {
    if (!score::is_hand(limb)) return 0.0;
    return (animation_->limb_point(placement_, limb, event) - animation_->target(limb, event))
        .norm();
}

/// At least, from one stroke to another.
double LiveDrummer::gap(Limb limb, const Past& past, std::size_t event) const {
    if (!score::is_hand(limb)) return kit_.limits.foot;
    const bool same = kit_.events[past.hit.event].object == kit_.events[event].object;
    if (same && !past.bounced) return kit_.limits.bounce;
    const double distance = effort_.distance(limb, past.hit.event, event);
    return std::max(kit_.limits.interval, distance / kit_.limits.speed + kit_.limits.settling);
}

/// When the limb can strike; nothing if it is not free for that.
std::optional<double> LiveDrummer::earliest(Limb limb, std::size_t event) const {
    if (!animation_->poses().of(limb, event)) return std::nullopt;
    if (score::is_hand(limb) && !kit_.events[event].reach[index(limb)]) return std::nullopt;
    const LimbState& state = of(limb);
    double time = now_ + kShortest;
    if (state.coming.empty()) {
        time = std::max(time, now_ + way(limb, event) / kit_.limits.speed + kit_.limits.settling);
    }
    if (state.past.any) {
        time = std::max(time, state.past.hit.time + gap(limb, state.past, event) + kTogether);
    }
    if (time > now_ + kLongestWait) return std::nullopt;
    if (song_.rate <= 0.0) return time;
    for (auto next = next_in_song(limb); next != state.strokes.end(); ++next) {
        if (due(*next) < state.ready) continue;
        Past now{{time, 0.5, 1.0, event}, true, true};
        const double back = gap(limb, now, strokes_[*next].event) + kToReturn;
        return due(*next) < time + back ? std::nullopt : std::optional(time);
    }
    return time;
}

double LiveDrummer::burden(Limb hand, std::size_t event, double time) const {
    const score::HandHit hit{time, 0.5, 1.0, event};
    const Past& own = of(hand).past;
    const Past& other = of(score::other_hand(hand)).past;
    const score::Effort effort = effort_.of(hit, hand, {own.any ? &own.hit : nullptr, own.bounced},
                                            {other.any ? &other.hit : nullptr, other.bounced});
    const bool crosses = effort.obstacle == score::Obstacle::crossing;
    return effort.total() + kDearWait * (time - now_) + (crosses ? kDearCrossing : 0.0);
}

LiveStroke LiveDrummer::strike(std::size_t event, double velocity, bool sounded) {
    std::optional<Limb> chosen;
    double least = 0.0, time = 0.0;
    for (const Limb limb : kLimbs) {
        const std::optional<double> at = earliest(limb, event);
        if (!at) continue;
        const double burden = score::is_hand(limb) ? this->burden(limb, event, *at) : 0.0;
        if (chosen && burden >= least) continue;
        chosen = limb;
        least = burden;
        time = *at;
    }
    if (!chosen) return {std::nullopt, now_};
    LimbState& state = of(*chosen);
    const KitContact contact{time, *chosen, event, velocity, -1, sounded};
    state.motion.perform(keys(*chosen, contact));
    state.coming.push_back(contact);
    const bool again = state.past.any && time - state.past.hit.time < kit_.limits.interval;
    state.past = {{time, velocity, 1.0, event}, true, again && !state.past.bounced};
    work_hat(kit_.events[event], time);
    return {chosen, time};
}

/// From where the limb is, after what it is already about to strike.
std::vector<KeyFrame> LiveDrummer::keys(Limb limb, const KitContact& contact) const {
    const LimbState& state = of(limb);
    const StrikePoses& poses = *animation_->poses().of(limb, contact.event);
    const StrokeTimes times = times_of(limb);
    std::vector<KeyFrame> keys;
    if (!state.coming.empty()) {
        keys = *state.motion.performed();
        const double last = state.coming.back().time + times.held + kTogether;
        while (keys.back().time > last) keys.pop_back();
    } else {
        keys.push_back({now_, KeyKind::rest, state.motion.pose()});
    }
    const double room = contact.time - keys.back().time;
    if (room > times.fall + kRoomToLift) {
        keys.push_back({contact.time - times.fall, KeyKind::before,
                        blend(poses.down, poses.up, std::max(contact.velocity, kLeastLift))});
    } else if (room > kRoomToLift) {
        const double lift = std::clamp(contact.velocity, kLeastLift, 0.5 * room / times.fall);
        keys.push_back(
            {contact.time - 0.5 * room, KeyKind::merged, blend(poses.down, poses.up, lift)});
    }
    const double released = contact.time + times.held;
    const double bounce =
        std::max(contact.velocity * kit_.events[contact.event].elasticity, kLeastLift);
    const LimbPose after = blend(poses.down, poses.up, bounce);
    keys.push_back({contact.time, KeyKind::contact, poses.down});
    keys.push_back({released, KeyKind::release, poses.down});
    // Where the song wants it back it goes at once.
    const auto next = next_in_song(limb);
    const bool wanted = song_.rate > 0.0 && next != state.strokes.end();
    const double left = wanted ? due(*next) - released : 1e9;
    keys.push_back({released + std::min(times.rise, kShareOfReturn * left), KeyKind::after, after});
    if (left > times.rise + kLingers + kGentle) {
        keys.push_back({released + times.rise + kLingers, KeyKind::rest, after});
    }
    return keys;
}

/// The foot that the hi-hat hangs on opens or closes it, if it has nothing else to do.
void LiveDrummer::work_hat(const score::KitEvent& event, double time) {
    if (event.foot || event.hat == score::HatState::any) return;
    for (const score::Pedal& pedal : kit_.pedals) {
        LimbState& foot = of(pedal.foot);
        if (pedal.object != event.object || !foot.coming.empty()) continue;
        const auto next = next_in_song(pedal.foot);
        if (song_.rate > 0.0 && next != foot.strokes.end() && due(*next) < time + kHatStays) return;
        for (std::size_t e = 0; e < kit_.events.size(); ++e) {
            const auto& press = animation_->poses().of(pedal.foot, e);
            if (!press) continue;
            const double up = event.hat == score::HatState::open ? kHatOpen : 0.0;
            const LimbPose pose = blend(press->down, press->up, up);
            foot.motion.perform({{now_, KeyKind::rest, foot.motion.pose()},
                                 {time - kHatReady, KeyKind::rest, pose},
                                 {time + kHatStays, KeyKind::rest, pose}});
            return;
        }
    }
}

void LiveDrummer::show(const std::optional<ShownPose>& pose) {
    if (pose &&
        (pose->event >= kit_.events.size() || !animation_->poses().of(pose->limb, pose->event))) {
        throw std::invalid_argument("expected an event that the " + std::string(name(pose->limb)) +
                                    " plays");
    }
    shown_ = pose;
}

void LiveDrummer::edit(const score::PoseEdit& pose) {
    animation_->edit(pose);
    std::erase_if(kit_.poses, [&](const score::PoseEdit& p) {
        return p.limb == pose.limb && p.event == pose.event && p.up == pose.up &&
               p.joint == pose.joint;
    });
    kit_.poses.push_back(pose);
}

void LiveDrummer::edit(const score::Script& script) {
    score::Kit changed = kit_;
    std::erase_if(changed.scripts, [&](const score::Script& s) {
        return s.joint == script.joint && s.phase == script.phase;
    });
    changed.scripts.push_back(script);
    score::check(changed);
    kit_.scripts = std::move(changed.scripts);
    animation_->lay();
}

}  // namespace percussionist::body
