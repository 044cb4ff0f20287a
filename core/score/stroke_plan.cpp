#include "core/score/stroke_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "core/score/sticking.hpp"

namespace percussionist::score {

namespace {

/// Of the softest and of the loudest note [m/s].
constexpr double kSoftestSpeed = 0.7;
constexpr double kLoudestSpeed = 4.5;

constexpr double kDoubleWithin = 0.001;  ///< [s]
constexpr double kGroupWithin = 0.012;   ///< [s]
constexpr std::size_t kMostNotes = 1'000'000;

using Indices = std::vector<std::size_t>;

std::string words(const char* format, double a) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), format, a);
    return text.data();
}

void check(const Score& score, const PlanOptions& options) {
    if (!(std::isfinite(options.min_interval) && options.min_interval > 0.0)) {
        throw std::invalid_argument("stroke plan: min_interval must be a finite time above 0");
    }
    if (score.notes.size() > kMostNotes) {
        throw std::invalid_argument("stroke plan: the score has more than a million notes");
    }
    for (const Note& note : score.notes) {
        if (!std::isfinite(note.time) || !(note.velocity > 0.0 && note.velocity <= 1.0)) {
            throw std::invalid_argument(
                "stroke plan: a note needs a finite time and a velocity above 0 and up to 1");
        }
    }
}

class Planner {
  public:
    Planner(const Score& score, const PlanOptions& options) : score_(score), options_(options) {}

    StrokePlan plan() {
        const Indices asked = without_doubles(asked_for());
        form_groups(asked);
        const std::vector<Played> played = assign_hands(hits_, groups_, options_.min_interval);
        write_strokes(played);
        explain_too_fast(played);
        put_in_order(plan_.left_out);
        put_in_order(plan_.doubles);
        return std::move(plan_);
    }

  private:
    [[nodiscard]] const Note& note(std::size_t i) const { return score_.notes[i]; }

    [[nodiscard]] LeftOut left_out(std::size_t i, Why why, std::string reason) const {
        return {i, note(i).time, note(i).position, why, std::move(reason)};
    }

    Indices asked_for() {
        Indices all(score_.notes.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        std::stable_sort(all.begin(), all.end(), [this](std::size_t a, std::size_t b) {
            return note(a).time < note(b).time;
        });
        const std::vector<int>& names = options_.instruments;
        if (names.empty()) {
            return all;
        }
        Indices asked;
        for (const std::size_t i : all) {
            if (std::find(names.begin(), names.end(), note(i).instrument) != names.end()) {
                asked.push_back(i);
            } else {
                plan_.left_out.push_back(
                    left_out(i, Why::not_asked_for, "its instrument was not asked for"));
            }
        }
        return asked;
    }

    /// Of events of one instrument within a millisecond of the first, the loudest stays.
    Indices without_doubles(const Indices& asked) {
        struct Struck {
            double time;
            std::size_t place;
        };
        std::unordered_map<int, Struck> last;
        Indices kept;
        for (std::size_t i : asked) {
            const auto found = last.find(note(i).instrument);
            if (found == last.end() || note(i).time - found->second.time > kDoubleWithin) {
                last.insert_or_assign(note(i).instrument, Struck{note(i).time, kept.size()});
                kept.push_back(i);
                continue;
            }
            std::size_t& stays = kept[found->second.place];
            if (note(i).velocity > note(stays).velocity) {
                std::swap(i, stays);
            }
            plan_.doubles.push_back(left_out(
                i, Why::double_event, "the same instrument sounds within a millisecond of it"));
        }
        std::stable_sort(kept.begin(), kept.end(), [this](std::size_t a, std::size_t b) {
            return note(a).time < note(b).time;
        });
        return kept;
    }

    void form_groups(const Indices& asked) {
        for (std::size_t first = 0; first < asked.size();) {
            std::size_t end = first + 1;
            while (end < asked.size() &&
                   note(asked[end]).time - note(asked[first]).time <= kGroupWithin) {
                ++end;
            }
            add_group({asked.begin() + first, asked.begin() + end});
            first = end;
        }
    }

    void add_group(Indices group) {
        if (group.size() > 2) {
            std::stable_sort(group.begin(), group.end(), [this](std::size_t a, std::size_t b) {
                return note(a).velocity != note(b).velocity
                           ? note(a).velocity > note(b).velocity
                           : note(a).instrument < note(b).instrument;
            });
            for (std::size_t k = 2; k < group.size(); ++k) {
                plan_.left_out.push_back(left_out(group[k], Why::third_at_once,
                                                  "a third note at one instant, for two hands"));
            }
            group.resize(2);
            if (note(group[1]).time < note(group[0]).time) {
                std::swap(group[0], group[1]);
            }
        }
        groups_.push_back({hits_.size(), group.size()});
        for (const std::size_t i : group) {
            hits_.push_back({note(i).time, note(i).velocity, note(i).position.beat});
            notes_.push_back(i);
        }
    }

    void write_strokes(const std::vector<Played>& played) {
        std::array<double, 2> last{-1e9, -1e9};
        for (std::size_t h = 0; h < hits_.size(); ++h) {
            if (played[h] == Played::not_at_all) {
                continue;
            }
            const Note& n = note(notes_[h]);
            Stroke stroke;
            stroke.time = n.time;
            stroke.hand = static_cast<int>(played[h]);
            stroke.velocity = n.velocity;
            stroke.speed = impact_speed(n.velocity, n.nuance);
            stroke.height = std::min(preparation_height(stroke.speed),
                                     reachable_height(stroke.speed, n.time - last[stroke.hand]));
            stroke.note = notes_[h];
            stroke.position = n.position;
            stroke.nuance = n.nuance;
            plan_.strokes.push_back(stroke);
            last[stroke.hand] = n.time;
        }
    }

    void explain_too_fast(const std::vector<Played>& played) {
        for (std::size_t h = 0; h < hits_.size(); ++h) {
            if (played[h] == Played::not_at_all) {
                plan_.left_out.push_back(
                    left_out(notes_[h], Why::too_fast,
                             "faster than a hand can move: " + in_the_way(h, Played::left, played) +
                                 ", " + in_the_way(h, Played::right, played)));
            }
        }
    }

    /// "the left strikes 62 ms before it": the stroke that keeps a hand from playing a hit.
    [[nodiscard]] std::string in_the_way(std::size_t hit, Played hand,
                                         const std::vector<Played>& played) const {
        const std::string name = hand == Played::left ? "the left" : "the right";
        for (std::size_t b = hit; b-- > 0 && apart(b, hit) < options_.min_interval;) {
            if (played[b] == hand) {
                return name + words(" strikes %.0f ms before it", 1e3 * apart(b, hit));
            }
        }
        for (std::size_t a = hit + 1; a < hits_.size() && apart(hit, a) < options_.min_interval;
             ++a) {
            if (played[a] == hand) {
                return name + words(" strikes %.0f ms after it", 1e3 * apart(hit, a));
            }
        }
        return name + " is free";
    }

    [[nodiscard]] double apart(std::size_t a, std::size_t b) const {
        return hits_[b].time - hits_[a].time;
    }

    static void put_in_order(std::vector<LeftOut>& list) {
        std::stable_sort(list.begin(), list.end(), [](const LeftOut& a, const LeftOut& b) {
            return a.time != b.time ? a.time < b.time : a.note < b.note;
        });
    }

    const Score& score_;
    const PlanOptions& options_;
    StrokePlan plan_;
    std::vector<Hit> hits_;
    Indices notes_;  ///< of the score, one for each hit
    std::vector<HitGroup> groups_;
};

}  // namespace

StrokePlan plan_strokes(const Score& score, const PlanOptions& options) {
    check(score, options);
    return Planner(score, options).plan();
}

std::string describe(const LeftOut& left_out, const Score& score) {
    std::array<char, 96> where{};
    std::snprintf(where.data(), where.size(), "bar %d beat %.2f (%.3f s) ", left_out.position.bar,
                  left_out.position.beat, left_out.time);
    return where.data() + instrument_name(score.notes.at(left_out.note).instrument) + ": " +
           left_out.reason;
}

double impact_speed(double velocity) {
    const double steps = (127.0 * velocity - 1.0) / 126.0;
    return kSoftestSpeed * std::pow(kLoudestSpeed / kSoftestSpeed, steps);
}

double velocity_of_impact(double speed) {
    const double steps = std::log(speed / kSoftestSpeed) / std::log(kLoudestSpeed / kSoftestSpeed);
    return (1.0 + 126.0 * steps) / 127.0;
}

double impact_speed(double velocity, Nuance nuance) {
    constexpr double kFastest = 6.0;
    return std::min(kFastest, impact_speed(velocity) * impact_ratio(nuance));
}

double preparation_height(double speed) {
    // Timpanists: 0.40 m before legato strokes of 1.9 m/s, 0.56 m before accents of 4.4 m/s; a
    // softer stroke is a smaller one.
    constexpr double kHeight = 0.40;
    constexpr double kSpeed = 1.9;
    const double ratio = speed / kSpeed;
    return kHeight * (ratio < 1.0 ? ratio : std::pow(ratio, 0.4));
}

double reachable_height(double speed, double interval) {
    constexpr double kContact = 0.010;
    return std::max(0.0, speed * (interval - kContact) / 4.0);
}

}  // namespace percussionist::score
