#include "core/score/kit_plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "core/score/kit_effort.hpp"
#include "core/score/kit_feet.hpp"
#include "core/score/kit_sticking.hpp"

namespace percussionist::score {

namespace {

constexpr double kDoubleWithin = 0.001;  // [s]
constexpr double kSoon = 0.2;            // [s]
constexpr std::size_t kMostNotes = 1'000'000;

std::string milliseconds(double seconds) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f ms", 1e3 * seconds);
    return text.data();
}

void check_notes(const Score& score) {
    if (score.notes.size() > kMostNotes) {
        throw std::invalid_argument("kit plan: the score has more than a million notes");
    }
    for (const Note& note : score.notes) {
        if (!std::isfinite(note.time) || !(note.velocity > 0.0 && note.velocity <= 1.0)) {
            throw std::invalid_argument(
                "kit plan: a note needs a finite time and a velocity above 0 and up to 1");
        }
    }
}

std::string spoken(Limb limb) {
    std::string words(name(limb));
    std::replace(words.begin(), words.end(), '-', ' ');
    return words;
}

/// A note that some limb is to play.
struct Wanted {
    std::size_t note;
    std::size_t event;
};

class Planner {
  public:
    Planner(const Score& score, const Kit& kit) : score_(score), kit_(kit), effort_(kit) {}

    KitPlan plan() {
        const std::vector<Wanted> wanted = without_doubles(of_the_kit());
        for (const Limb foot : {Limb::left_foot, Limb::right_foot}) play_foot(wanted, foot);
        form_groups(wanted);
        write_strokes(assign_hands(kit_, hits_, groups_));
        put_in_order();
        return std::move(plan_);
    }

  private:
    [[nodiscard]] const Note& note(const Wanted& w) const { return score_.notes[w.note]; }
    [[nodiscard]] const KitEvent& event(const Wanted& w) const { return kit_.events[w.event]; }
    void leave_out(std::size_t note, std::string reason) {
        plan_.left_out.push_back({note, std::move(reason)});
    }

    std::vector<Wanted> of_the_kit() {
        std::vector<std::size_t> all(score_.notes.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        std::stable_sort(all.begin(), all.end(), [this](std::size_t a, std::size_t b) {
            return score_.notes[a].time < score_.notes[b].time;
        });
        std::vector<Wanted> wanted;
        for (const std::size_t i : all) {
            const int key = score_.notes[i].instrument;
            const int found = key >= 0 && key < kKeys ? kit_.keys[key] : kNotOfTheKit;
            if (found == kNotOfTheKit) {
                leave_out(i, "nothing on the kit plays it");
            } else {
                wanted.push_back({i, static_cast<std::size_t>(found)});
            }
        }
        return wanted;
    }

    /// Hand and foot may play one object at once.
    std::vector<Wanted> without_doubles(const std::vector<Wanted>& wanted) {
        struct Last {
            double time;
            std::size_t place;
        };
        std::vector<std::optional<Last>> last(2 * kit_.objects.size());
        std::vector<Wanted> kept;
        for (Wanted w : wanted) {
            auto& before = last[2 * event(w).object + (event(w).foot ? 1 : 0)];
            if (!before || note(w).time - before->time > kDoubleWithin) {
                before = {note(w).time, kept.size()};
                kept.push_back(w);
                continue;
            }
            Wanted& stays = kept[before->place];
            if (note(w).velocity > note(stays).velocity) std::swap(w, stays);
            plan_.doubles.push_back(
                {w.note, kit_.objects[event(w).object].name + " is struck at this instant"});
        }
        std::stable_sort(kept.begin(), kept.end(), [this](const Wanted& a, const Wanted& b) {
            return note(a).time < note(b).time;
        });
        return kept;
    }

    void play_foot(const std::vector<Wanted>& wanted, Limb foot) {
        std::vector<FootHit> hits;
        std::vector<Wanted> asked;
        for (const Wanted& w : wanted) {
            if (event(w).foot != foot) continue;
            hits.push_back({note(w).time, note(w).velocity});
            asked.push_back(w);
        }
        const std::vector<bool> played = thin(hits, kit_.limits.foot);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (played[i]) {
                plan_.strokes.push_back({note(asked[i]).time, foot, asked[i].event,
                                         note(asked[i]).velocity, asked[i].note, false,
                                         Reason::foot});
            } else {
                leave_out(asked[i].note, "the " + spoken(foot) + " strikes at most every " +
                                             milliseconds(kit_.limits.foot));
            }
        }
    }

    void form_groups(const std::vector<Wanted>& wanted) {
        std::vector<Wanted> group;
        for (const Wanted& w : wanted) {
            if (event(w).foot) continue;
            if (!group.empty() && note(w).time - note(group.front()).time > HandEffort::kAtOnce) {
                add_group(group);
                group.clear();
            }
            group.push_back(w);
        }
        if (!group.empty()) add_group(group);
    }

    void add_group(std::vector<Wanted>& group) {
        constexpr std::size_t kHands = 2;
        if (group.size() > kHands) {
            std::stable_sort(group.begin(), group.end(), [this](const Wanted& a, const Wanted& b) {
                return note(a).velocity != note(b).velocity ? note(a).velocity > note(b).velocity
                                                            : a.event < b.event;
            });
            for (std::size_t k = kHands; k < group.size(); ++k) {
                leave_out(group[k].note, "a third note for two hands at one instant");
            }
            group.resize(kHands);
            if (note(group[1]).time < note(group[0]).time) std::swap(group[0], group[1]);
        }
        groups_.push_back({hits_.size(), group.size()});
        for (const Wanted& w : group) {
            hits_.push_back({note(w).time, note(w).velocity, note(w).position.beat, w.event});
            notes_.push_back(w.note);
        }
    }

    void write_strokes(const std::vector<Played>& played) {
        std::array<HandPast, 2> past{};
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            const HandHit& hit = hits_[i];
            for (HandPast& p : past) {
                if (p.hit != nullptr && hit.time - p.hit->time > HandEffort::kMemory) p = {};
            }
            if (played[i] == Played::not_at_all) {
                leave_out(notes_[i], "faster than hands can: " + in_the_way(i, played, past));
                continue;
            }
            const Limb hand = played[i] == Played::left ? Limb::left_hand : Limb::right_hand;
            const std::size_t h = index(hand);
            const bool bounces = effort_.alone(hit, hand, past[h]).bounces;
            plan_.strokes.push_back({hit.time, hand, hit.event, hit.velocity, notes_[i], bounces,
                                     why(hit, hand, past)});
            past[h] = {&hit, bounces};
        }
    }

    [[nodiscard]] Reason why(const HandHit& hit, Limb hand,
                             const std::array<HandPast, 2>& past) const {
        const std::size_t h = index(hand);
        const Effort here = effort_.of(hit, hand, past[h], past[1 - h]);
        const Effort there = effort_.of(hit, other_hand(hand), past[1 - h], past[h]);
        if (there.obstacle == Obstacle::crossing) return Reason::crossing;
        if (!there.possible()) return Reason::only;
        if (here.total() > there.total()) return Reason::course;
        const std::array<std::pair<double, Reason>, 5> parts{
            {{there.pair - here.pair, Reason::pair},
             {there.preference - here.preference, Reason::preference},
             {there.repeat - here.repeat, Reason::alternation},
             {there.way - here.way, Reason::way},
             {there.lead - here.lead, Reason::lead}}};
        return std::max_element(parts.begin(), parts.end(),
                                [](const auto& a, const auto& b) { return a.first < b.first; })
            ->second;
    }

    /// "the left hand struck ride 120 ms before and strikes snare 40 ms after": what keeps both.
    [[nodiscard]] std::string in_the_way(std::size_t i, const std::vector<Played>& played,
                                         const std::array<HandPast, 2>& past) const {
        std::string text;
        for (const Limb hand : {Limb::left_hand, Limb::right_hand}) {
            const HandHit* const before = past[index(hand)].hit;
            const HandHit* const after = next_of(i, hand, played);
            text += (text.empty() ? "the " : ", the ") + spoken(hand);
            if (before != nullptr) text += " struck " + seen_from(hits_[i], *before) + " before";
            if (before != nullptr && after != nullptr) text += " and";
            if (after != nullptr) text += " strikes " + seen_from(hits_[i], *after) + " after";
            if (before == nullptr && after == nullptr) text += " is free";
        }
        return text;
    }

    [[nodiscard]] std::string seen_from(const HandHit& here, const HandHit& there) const {
        return kit_.events[there.event].name + " " + milliseconds(std::abs(there.time - here.time));
    }

    /// The hand's next hit, if it comes soon.
    [[nodiscard]] const HandHit* next_of(std::size_t i, Limb hand,
                                         const std::vector<Played>& played) const {
        const Played way = hand == Limb::left_hand ? Played::left : Played::right;
        for (std::size_t k = i + 1; k < hits_.size(); ++k) {
            if (hits_[k].time - hits_[i].time > kSoon) return nullptr;
            if (played[k] == way) return &hits_[k];
        }
        return nullptr;
    }

    void put_in_order() {
        const auto by_time = [this](const auto& a, const auto& b) {
            const double ta = score_.notes[a.note].time, tb = score_.notes[b.note].time;
            return ta != tb ? ta < tb : a.note < b.note;
        };
        std::sort(plan_.strokes.begin(), plan_.strokes.end(), by_time);
        std::sort(plan_.left_out.begin(), plan_.left_out.end(), by_time);
        std::sort(plan_.doubles.begin(), plan_.doubles.end(), by_time);
    }

    const Score& score_;
    const Kit& kit_;
    HandEffort effort_;
    KitPlan plan_;
    std::vector<HandHit> hits_;
    std::vector<std::size_t> notes_;  ///< of the score, one for each hit
    std::vector<HitGroup> groups_;
};

}  // namespace

KitPlan plan_kit(const Score& score, const Kit& kit) {
    check(kit);
    check_notes(score);
    return Planner(score, kit).plan();
}

std::string describe(const KitLeftOut& left_out, const Score& score) {
    const Note& note = score.notes.at(left_out.note);
    std::array<char, 96> where{};
    std::snprintf(where.data(), where.size(), "bar %d beat %.2f (%.3f s) ", note.position.bar,
                  note.position.beat, note.time);
    return where.data() + instrument_name(note.instrument) + ": " + left_out.reason;
}

KitAudit audit(const KitPlan& plan, const Kit& kit) {
    constexpr double kTopSpeed = 20.0, kTopOverMean = 2.0;  // [m/s]
    constexpr double kShortest = 1.0 / 16.0;                // [s]
    const HandEffort effort(kit);
    KitAudit counts;
    std::array<const KitStroke*, 2> last{};
    for (const KitStroke& stroke : plan.strokes) {
        if (!is_hand(stroke.limb)) continue;
        ++counts.hits;
        const std::size_t h = index(stroke.limb);
        const KitStroke* const own = last[h];
        const KitStroke* const other = last[1 - h];
        if (own != nullptr) {
            const double gap = stroke.time - own->time;
            const double way = effort.distance(stroke.limb, own->event, stroke.event);
            counts.too_often += gap < kShortest ? 1 : 0;
            counts.too_fast += way / gap > kTopSpeed / kTopOverMean ? 1 : 0;
        }
        if (other != nullptr && stroke.time - other->time <= HandEffort::kCrossingWithin) {
            const bool left = stroke.limb == Limb::left_hand;
            counts.crossed += effort.crossed(left ? stroke.event : other->event,
                                             left ? other->event : stroke.event)
                                  ? 1
                                  : 0;
        }
        last[h] = &stroke;
    }
    return counts;
}

}  // namespace percussionist::score
