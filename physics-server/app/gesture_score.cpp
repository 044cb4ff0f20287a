#include "app/gesture_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "files/text_file.hpp"

namespace percussionist::app {

using body::Hand;
using body::kHands;

namespace {

/// Of the curves [s].
constexpr double kEvery = 0.004;
/// What a player can do: of the tip [m/s], and how long a joint may be at its limit.
constexpr double kFastestTip = 15.0;
constexpr double kMostStrained = 0.1;
constexpr double kMostOff = 0.005;
/// A joint this near its limit is at it.
constexpr double kAtLimit = 0.98;

/// Gathers one hand's movement until its stroke strikes.
struct Gathering {
    std::vector<GestureOfStroke> waiting;  ///< given, not yet struck
    double raised = 0.0, fastest = 0.0, acceleration = 0.0;
    int steps = 0, strained = 0;
};

class Watcher {
  public:
    explicit Watcher(Performance& performance) : performance_(performance) {
        const body::Skeleton& skeleton = performance.simulation().skeleton();
        for (const Hand hand : kHands) {
            for (int i = 1; i < skeleton.size(); ++i) {
                if (skeleton.moves(i, skeleton.stick_index(hand))) {
                    chain_[static_cast<int>(hand)].push_back(i);
                }
            }
        }
    }

    PlayedScore play() {
        performance_.play();
        while (performance_.playing()) {
            const auto& contacts = performance_.step();
            for (const Asked& given : performance_.player().given()) take(given);
            for (const Hand hand : kHands) watch(hand);
            for (const LoggedContact& contact : contacts) note(contact);
            curves();
        }
        for (auto& [stroke, gesture] : found_) played_.strokes.push_back(gesture);
        std::sort(played_.strokes.begin(), played_.strokes.end(),
                  [](const GestureOfStroke& a, const GestureOfStroke& b) {
                      return a.asked.time < b.asked.time;
                  });
        return std::move(played_);
    }

  private:
    void take(const Asked& given) {
        finish(given.hand);
        GestureOfStroke g;
        g.asked = given;
        g.stroke = performance_.player().strokes()[given.stroke];
        const auto& in_place = performance_.player().gesture(given.hand);
        g.gesture = in_place ? in_place->name : std::string(score::name(g.stroke.nuance));
        found_[given.stroke] = g;
        current_[static_cast<int>(given.hand)] = given.stroke;
        gathering_[static_cast<int>(given.hand)] = {};
    }

    /// What was gathered belongs to the stroke that has now been struck.
    void finish(Hand hand) {
        const auto current = current_.find(static_cast<int>(hand));
        if (current == current_.end()) return;
        const Gathering& made = gathering_[static_cast<int>(hand)];
        GestureOfStroke& g = found_[current->second];
        g.raised = made.raised;
        g.fastest = made.fastest;
        g.acceleration = made.acceleration;
        g.strained = made.steps > 0 ? static_cast<double>(made.strained) / made.steps : 0.0;
    }

    void watch(Hand hand) {
        const sim::Simulation& simulation = performance_.simulation();
        const double t = simulation.time();
        const body::StrokePath& path = simulation.path(hand);
        if (path.in_head(t) || !path.aiming(t)) return;
        Gathering& made = gathering_[static_cast<int>(hand)];
        const body::PathState tip = path.tip(t);
        made.raised = std::max(made.raised, tip.position);
        made.fastest = std::max(made.fastest, std::abs(tip.velocity));
        made.acceleration = std::max(made.acceleration, std::abs(tip.acceleration));
        ++made.steps;
        const auto at_limit = [&](int i) {
            return simulation.controller().torque(i).cwiseAbs().maxCoeff() >
                   kAtLimit * simulation.skeleton().segments[i].torque_limit;
        };
        const auto& chain = chain_[static_cast<int>(hand)];
        if (std::any_of(chain.begin(), chain.end(), at_limit)) ++made.strained;
    }

    void note(const LoggedContact& contact) {
        if (contact.stroke < 0 || contact.event.recontact) return;
        const auto found = found_.find(static_cast<std::size_t>(contact.stroke));
        if (found == found_.end()) return;
        found->second.struck = true;
        found->second.asked.time = contact.asked_time;
        found->second.contact_error = contact.event.instant - contact.asked_time;
        finish(contact.event.hand);
    }

    void curves() {
        const sim::Simulation& simulation = performance_.simulation();
        const double t = simulation.time();
        if (t < next_) return;
        next_ += kEvery;
        for (const Hand hand : kHands) {
            const auto i = static_cast<std::size_t>(hand);
            played_.asked[i].emplace_back(t, simulation.path(hand).tip(t).position);
            played_.made[i].emplace_back(t, simulation.tip(hand).z());
        }
        played_.tempo.emplace_back(t, performance_.player().tempo().factor(t));
    }

    Performance& performance_;
    PlayedScore played_;
    std::map<std::size_t, GestureOfStroke> found_;
    std::map<int, std::size_t> current_;
    std::array<Gathering, 2> gathering_;
    std::array<std::vector<int>, 2> chain_;
    double next_ = 0.0;
};

std::string csv_of(const PlayedScore& score) {
    std::string text =
        "time_s,hand,gesture,speed_m_s,raised_m,fastest_m_s,acceleration_m_s2,strained,struck,"
        "error_s,playable\n";
    for (const GestureOfStroke& g : score.strokes) {
        text += fmt::format("{:.6f},{},{},{:.3f},{:.4f},{:.3f},{:.1f},{:.3f},{},{:.6f},{}\n",
                            g.asked.time, g.asked.hand == Hand::left ? "left" : "right", g.gesture,
                            g.asked.shape.impact, g.raised, g.fastest, g.acceleration, g.strained,
                            g.struck ? 1 : 0, g.contact_error, g.playable() ? 1 : 0);
    }
    return text;
}

std::string heights_csv(const PlayedScore& score) {
    std::string text = "time_s,left_asked_m,left_m,right_asked_m,right_m\n";
    for (std::size_t i = 0; i < score.made[0].size(); ++i) {
        text += fmt::format("{:.4f},{:.5f},{:.5f},{:.5f},{:.5f}\n", score.made[0][i].first,
                            score.asked[0][i].second, score.made[0][i].second,
                            score.asked[1][i].second, score.made[1][i].second);
    }
    return text;
}

}  // namespace

bool GestureOfStroke::playable() const {
    return struck && std::abs(contact_error) < kMostOff && fastest < kFastestTip &&
           strained < kMostStrained;
}

PlayedScore play_through(Performance& performance) {
    return Watcher(performance).play();
}

void write_gesture_score(const PlayedScore& score, const std::string& title, double seconds,
                         const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    files::write_text(folder / "strokes.csv", csv_of(score));
    files::write_text(folder / "heights.csv", heights_csv(score));
    files::GestureScore picture;
    picture.title = title;
    for (const GestureOfStroke& g : score.strokes) {
        const auto nuance = score::nuance_of(g.gesture).value_or(g.stroke.nuance);
        picture.notes.push_back({g.asked.time, static_cast<int>(g.asked.hand), nuance,
                                 g.stroke.position.bar, g.playable()});
    }
    picture.left_asked = score.asked[0];
    picture.left = score.made[0];
    picture.right_asked = score.asked[1];
    picture.right = score.made[1];
    picture.tempo = score.tempo;
    const double end = score.made[0].empty() ? 0.0 : score.made[0].back().first;
    for (int page = 0; page * seconds < end; ++page) {
        picture.from = page * seconds;
        picture.to = picture.from + seconds;
        files::write_svg(folder / fmt::format("score-{:02}.svg", page + 1), picture);
    }
}

}  // namespace percussionist::app
