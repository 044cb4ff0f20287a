#include "app/kit_performance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/score/stroke_plan.hpp"

namespace percussionist::app {

namespace {

using score::KitStroke;
using score::Limb;
using sim::KitContact;

constexpr double kLeadIn = 1.2;       // before the first stroke [s]
constexpr double kBounceTime = 0.25;  // after a stroke, what touches again is its bounce [s]
constexpr double kInTime = 0.005;     // [s]
constexpr double kFastest = 6.0;      // that is heard [m/s]

/// Which strokes each limb has behind and before it, as time goes on.
class Forecaster {
  public:
    explicit Forecaster(const std::vector<KitStroke>& strokes) : strokes_(strokes) {
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            own_[score::index(strokes[i].limb)].push_back(i);
        }
    }
    const body::LimbForecasts& at(double time) {
        for (std::size_t l = 0; l < own_.size(); ++l) {
            body::LimbForecast& f = forecasts_[l];
            std::size_t& next = next_[l];
            const auto stroke = [&](std::size_t i) -> const KitStroke& {
                return strokes_[own_[l][i]];
            };
            while (next < own_[l].size() && stroke(next).time <= time) ++next;
            if (next > 0) f.last = {stroke(next - 1).time, stroke(next - 1).event};
            f.next = {1e9, f.last.event};
            if (next < own_[l].size()) f.next = {stroke(next).time, stroke(next).event};
        }
        return forecasts_;
    }

  private:
    const std::vector<KitStroke>& strokes_;
    std::array<std::vector<std::size_t>, 4> own_;
    std::array<std::size_t, 4> next_{};
    body::LimbForecasts forecasts_;
};

/// Each stroke takes the contact of its limb on its object that is nearest in time.
void match(const score::Kit& kit, const std::vector<KitStroke>& strokes, KitPerformance& p) {
    std::vector<char> taken(p.contacts.size(), 0);
    p.of_stroke.assign(strokes.size(), std::nullopt);
    std::size_t first = 0;  // contacts are told in order of time but for some milliseconds
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        const auto off = [&](std::size_t c) {
            return p.contacts[c].contact.instant - strokes[s].time;
        };
        while (first < p.contacts.size() && off(first) < -1.0) ++first;
        for (std::size_t c = first; c < p.contacts.size() && off(c) < 1.0; ++c) {
            const bool own = p.contacts[c].limb == strokes[s].limb && !taken[c] &&
                             p.contacts[c].object == kit.events[strokes[s].event].object;
            if (!own || std::abs(off(c)) > sim::kOwnContact) continue;
            auto& best = p.of_stroke[s];
            if (!best || std::abs(off(c)) < std::abs(off(*best))) best = c;
        }
        if (p.of_stroke[s]) taken[*p.of_stroke[s]] = 1;
    }
    for (std::size_t c = 0; c < p.contacts.size(); ++c) {
        if (taken[c]) continue;
        const KitContact& contact = p.contacts[c];
        const bool bounce = std::any_of(strokes.begin(), strokes.end(), [&](const KitStroke& s) {
            const double since = contact.contact.instant - s.time;
            return s.limb == contact.limb && since > 0.0 && since < kBounceTime &&
                   kit.events[s.event].object == contact.object;
        });
        const bool hat = kit.objects[contact.object].kind == score::ObjectKind::hi_hat &&
                         !score::is_hand(contact.limb);
        (bounce ? p.bounces : hat ? p.closings : p.strays).push_back(c);
    }
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

KitPerformance perform_on_kit(const score::Kit& kit, const std::vector<KitStroke>& strokes,
                              const body::KitAnimation& animation,
                              std::vector<modal::Resonator> bodies, double end,
                              const std::function<void(const sim::KitSimulation&)>& see) {
    const double start = std::min(0.0, (strokes.empty() ? 0.0 : strokes.front().time) - kLeadIn);
    body::Posture posture(animation.skeleton());
    body::Placement placement(animation.skeleton());
    animation.at(start, posture, placement);
    sim::KitSimulation simulation(kit, std::move(bodies), posture, start);
    Forecaster forecaster(strokes);
    KitPerformance p;
    while (simulation.time() < end && p.sane) {
        animation.at(simulation.time() + simulation.step_length(), posture, placement);
        simulation.step(posture, forecaster.at(simulation.time()), p.contacts);
        for (const body::Hand hand : body::kHands) {
            const double speed = simulation.tip_speed(hand);
            if (speed > p.top_speed) {
                p.top_speed = speed;
                p.top_speed_at = simulation.time();
            }
            p.largest_error = std::max(p.largest_error, simulation.tip_error(hand));
        }
        p.sane = simulation.sane();
        if (simulation.time() >= 0.0) see(simulation);
    }
    match(kit, strokes, p);
    return p;
}

std::vector<KitStroke> heard(const score::Kit& kit, const std::vector<KitStroke>& strokes,
                             const KitPerformance& performance) {
    std::vector<std::size_t> events;
    for (const KitContact& c : performance.contacts) events.push_back(sim::event_of(kit, c));
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        if (performance.of_stroke[s]) events[*performance.of_stroke[s]] = strokes[s].event;
    }
    std::vector<KitStroke> all;
    for (std::size_t c = 0; c < events.size(); ++c) {
        const KitContact& contact = performance.contacts[c];
        const auto velocity = sim::note_velocity(kit.events[events[c]], contact);
        if (!velocity) continue;
        all.push_back({.time = contact.contact.instant,
                       .limb = contact.limb,
                       .event = events[c],
                       .velocity = *velocity});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const KitStroke& a, const KitStroke& b) { return a.time < b.time; });
    return all;
}

std::string all_contacts_csv(const score::Kit& kit, const KitPerformance& performance) {
    std::vector<const char*> what(performance.contacts.size(), "stroke");
    for (const std::size_t c : performance.bounces) what[c] = "bounce";
    for (const std::size_t c : performance.closings) what[c] = "closing";
    for (const std::size_t c : performance.strays) what[c] = "stray";
    std::string text = "time_s,object,limb,what,speed_m_s,impulse_ns,peak_n,duration_ms\n";
    for (std::size_t i = 0; i < what.size(); ++i) {
        const KitContact& c = performance.contacts[i];
        text += fmt::format("{:.6f},{},{},{},{:.3f},{:.5f},{:.1f},{:.2f}\n", c.contact.instant,
                            kit.objects[c.object].name, score::name(c.limb), what[i],
                            -c.contact.velocity.z(), c.contact.impulse, -c.contact.peak_force.z(),
                            1e3 * c.contact.duration);
    }
    return text;
}

std::string contacts_csv(const score::Kit& kit, const score::Score& score,
                         const std::vector<KitStroke>& strokes, const KitPerformance& performance) {
    std::string text =
        "time_s,bar,beat,key,event,object,limb,velocity,contact_s,late_ms,speed_m_s,off_mm,"
        "peak_n\n";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const KitStroke& s = strokes[i];
        const score::Note& note = score.notes[s.note];
        const score::KitObject& object = kit.object_of(s.event);
        text += fmt::format("{:.6f},{},{:.3f},{},{},{},{},{:.3f},", s.time, note.position.bar,
                            note.position.beat, note.instrument, kit.events[s.event].name,
                            object.name, score::name(s.limb), s.velocity);
        if (!performance.of_stroke[i]) {
            text += ",,,,\n";
            continue;
        }
        const sim::ContactEvent& c = performance.contacts[*performance.of_stroke[i]].contact;
        std::string off;
        if (score::is_hand(s.limb)) {
            const linear::Vector3 spot = object.orientation().conjugate() *
                                         (score::spot_of(kit, s.event, s.limb) - object.middle);
            off = fmt::format("{:.2f}", 1e3 * (c.place - spot).head<2>().norm());
        }
        text += fmt::format("{:.6f},{:.2f},{:.3f},{},{:.1f}\n", c.instant,
                            1e3 * (c.instant - s.time), -c.velocity.z(), off, -c.peak_force.z());
    }
    return text;
}

std::vector<std::pair<std::string, std::string>> account_of(const score::Kit& kit,
                                                            const std::vector<KitStroke>& strokes,
                                                            const KitPerformance& performance) {
    std::vector<double> off;
    std::size_t missed = 0, untimely = 0;
    double most = -1.0;
    std::string worst;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!performance.of_stroke[i]) {
            ++missed;
            continue;
        }
        const double late =
            performance.contacts[*performance.of_stroke[i]].contact.instant - strokes[i].time;
        if (std::abs(late) > kInTime) ++untimely;
        if (std::abs(late) > most) {
            most = std::abs(late);
            worst = fmt::format("{:+.2f} ms, {} by the {} at {:.3f} s", 1e3 * late,
                                kit.events[strokes[i].event].name, score::name(strokes[i].limb),
                                strokes[i].time);
        }
        off.push_back(std::abs(late));
    }
    return {
        {"contacts of strokes",
         fmt::format("{} = {} within 5 ms + {} later or earlier; {} strokes without a contact",
                     off.size(), off.size() - untimely, untimely, missed)},
        {"off its time", fmt::format("median {:.2f} ms, worst {}", 1e3 * median(off), worst)},
        {"contacts besides", fmt::format("{} bounces, {} silent closings of the hi-hat, {} strays",
                                         performance.bounces.size(), performance.closings.size(),
                                         performance.strays.size())},
        {"fastest tip",
         fmt::format("{:.1f} m/s, at {:.3f} s", performance.top_speed, performance.top_speed_at)},
        {"tip off its target", fmt::format("at most {:.1f} mm", 1e3 * performance.largest_error)},
    };
}

}  // namespace percussionist::app
