#include "app/steering.hpp"

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace percussionist::app {

using body::Hand;

namespace {

constexpr const char* kAsWritten = "score";

/// Calls `act` for the hand named, or for both.
template <typename Act>
void for_hands(const std::optional<int>& hand, const Act& act) {
    for (const Hand each : {Hand::left, Hand::right}) {
        if (!hand || *hand == static_cast<int>(each)) act(each);
    }
}

std::string nuance_name(const Player& player, Hand hand) {
    const auto& gesture = player.gesture(hand);
    return gesture ? gesture->name : kAsWritten;
}

}  // namespace

Steering::Steering(Performance& performance, std::vector<body::Gesture> gestures)
    : performance_(performance), gestures_(std::move(gestures)) {}

bool Steering::obey(const osc::Command& command) {
    return std::visit(
        [this](const auto& wish) {
            constexpr bool own = requires {
                set(wish);
            };
            if constexpr (own) {
                set(wish);
                changed_ = true;
            }
            return own;
        },
        command);
}

bool Steering::take_changed() {
    return std::exchange(changed_, false);
}

void Steering::set(const osc::Tempo& wish) {
    performance_.player().set_tempo(wish.factor, wish.seconds);
}

void Steering::set(const osc::Rubato& wish) {
    performance_.player().set_rubato(wish.depth, wish.period);
}

void Steering::set(const osc::SetGrip& wish) {
    if (wish.french == french_) return;
    french_ = wish.french;
    performance_.simulation().set_grip(french_ ? body::Grip::french : body::Grip::german);
}

void Steering::set(const osc::SetNuance& wish) {
    std::optional<body::Gesture> gesture;
    if (wish.name != kAsWritten) {
        const body::Gesture* found = body::find_gesture(gestures_, wish.name);
        if (found == nullptr) {
            std::string known = kAsWritten;
            for (const body::Gesture& g : gestures_) known += ", " + g.name;
            throw std::invalid_argument("NAME: expected one of " + known + ", got '" + wish.name +
                                        "'");
        }
        gesture = *found;
    }
    for_hands(wish.hand, [&](Hand hand) { performance_.player().set_gesture(hand, gesture); });
}

void Steering::set(const osc::SetHeight& wish) {
    performance_.player().set_height(wish.factor);
}

void Steering::set(const osc::SetPlace& wish) {
    for_hands(wish.hand,
              [&](Hand hand) { performance_.simulation().set_strike_radius(hand, wish.share); });
}

void Steering::set(const osc::SetLeading& wish) {
    performance_.player().set_leading(static_cast<Hand>(wish.hand));
}

void Steering::set(const osc::SetHeadHeight& wish) {
    performance_.simulation().set_head_height(wish.height);
}

void Steering::set(const osc::SetMembrane& wish) {
    modal::Membrane membrane = performance_.simulation().options().head.membrane;
    membrane.radius = wish.radius;
    membrane.tension = wish.tension;
    membrane.surface_density = wish.density;
    performance_.simulation().set_membrane(membrane);
}

void Steering::set(const osc::SetMallet& wish) {
    performance_.simulation().set_mallet(wish.mass, wish.stiffness);
}

void Steering::set(const osc::SetTracking& wish) {
    tips_ = wish.tips;
    performance_.simulation().set_tracking(tips_ ? body::Tracking::tips : body::Tracking::joints);
}

void Steering::set(const osc::SetInverse& wish) {
    static const std::map<std::string, body::Inverse> inverses{
        {"dls", body::Inverse::damped_least_squares},
        {"transpose", body::Inverse::transpose},
        {"learnt", body::Inverse::learnt}};
    if (wish.name == inverse_) return;
    inverse_ = wish.name;
    performance_.simulation().set_inverse(inverses.at(wish.name));
}

void Steering::set(const osc::SetLaw& wish) {
    performance_.simulation().controller().set_law(wish.paper ? sim::Law::paper
                                                              : sim::Law::implicit);
}

void Steering::set(const osc::SetGain& wish) {
    sim::Controller& controller = performance_.simulation().controller();
    if (controller.options().law == sim::Law::paper) {
        controller.set_paper_gains(wish.frequency, wish.damping);
    } else {
        controller.set_gains(wish.frequency, wish.damping);
    }
}

osc::StateMessage Steering::state(double wall) const {
    const Player& player = std::as_const(performance_).player();
    const sim::Simulation& simulation = std::as_const(performance_).simulation();
    const sim::ControlOptions& control = simulation.controller().options();
    const sim::DrumheadOptions& head = simulation.options().head;
    const score::TempoCurve& tempo = player.tempo();
    const bool paper = control.law == sim::Law::paper;
    return {
        wall,
        {{"tempo", {tempo.factor(simulation.time()), tempo.goal()}},
         {"rubato", {tempo.depth(), tempo.period()}},
         {"grip", {french_ ? "french" : "german"}},
         {"nuance", {nuance_name(player, Hand::left), nuance_name(player, Hand::right)}},
         {"height", {player.height()}},
         {"place", {simulation.strike_radius(Hand::left), simulation.strike_radius(Hand::right)}},
         {"leading", {player.leading() == Hand::left ? "left" : "right"}},
         {"drum-height", {simulation.options().head_height}},
         {"membrane", {head.membrane.radius, head.membrane.tension, head.membrane.surface_density}},
         {"mallet", {simulation.skeleton().stick.mass, head.tip.stiffness}},
         {"control", {tips_ ? "tips" : "joints"}},
         {"inverse", {inverse_}},
         {"law", {paper ? "paper" : "implicit"}},
         {"gain",
          {paper ? control.paper_frequency : control.frequency,
           paper ? control.paper_damping : control.damping}},
         {"playing", {performance_.playing() ? 1.0 : 0.0}}}};
}

}  // namespace percussionist::app
