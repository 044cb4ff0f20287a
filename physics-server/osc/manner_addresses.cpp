#include "osc/address_table.hpp"

namespace percussionist::osc {

namespace {

using Arguments = std::span<const Argument>;

double number(Arguments arguments, std::size_t index, double otherwise = 0.0) {
    return index < arguments.size() ? std::get<double>(arguments[index]) : otherwise;
}

const std::string& word(Arguments arguments, std::size_t index) {
    return std::get<std::string>(arguments[index]);
}

/// None for both.
std::optional<int> hand(Arguments arguments, std::size_t index) {
    if (index >= arguments.size() || word(arguments, index) == "both") return std::nullopt;
    return word(arguments, index) == "left" ? 0 : 1;
}

constexpr Parameter kHand{"HAND", "", true, false, 0, 0, false, "left right both"};

std::vector<Address> playing() {
    return {
        {"/tempo",
         "how fast, as a multiple of the score's own tempo; at once, or reached within SECONDS",
         {{"FACTOR", "", false, true, 0.1, 10.0}, {"SECONDS", "s", false, false, 0.0, 600.0}},
         [](Arguments a) -> Command {
             return Tempo{number(a, 0), number(a, 1)};
         }},
        {"/rubato",
         "the tempo sways by the share DEPTH within each PERIOD of the score; 0: not at all",
         {{"DEPTH", "", false, true, 0.0, 0.9}, {"PERIOD", "s", false, false, 0.2, 60.0}},
         [](Arguments a) -> Command {
             return Rubato{number(a, 0), number(a, 1, 4.0)};
         }},
        {"/grip",
         "palms down (german) or thumbs up (french)",
         {{"GRIP", "", true, true, 0, 0, false, "german french"}},
         [](Arguments a) -> Command { return SetGrip{word(a, 0) == "french"}; }},
        {"/nuance",
         "how each stroke is played: legato, tenuto, accent, vertical-accent, staccato, piston, a "
         "gesture of your own, or score: as it is written",
         {{"NAME", "", true, true, 0, 80}, kHand},
         [](Arguments a) -> Command {
             return SetNuance{word(a, 0), hand(a, 1)};
         }},
        {"/height",
         "sticks are raised so many times as high",
         {{"FACTOR", "", false, true, 0.2, 2.0}},
         [](Arguments a) -> Command { return SetHeight{number(a, 0)}; }},
        {"/place",
         "where on the head, as a share of its radius: 0 its middle, 1 its rim",
         {{"SHARE", "", false, true, 0.05, 0.95}, kHand},
         [](Arguments a) -> Command {
             return SetPlace{number(a, 0), hand(a, 1)};
         }},
        {"/leading",
         "the hand that plays what the score gives the right one",
         {{"HAND", "", true, true, 0, 0, false, "left right"}},
         [](Arguments a) -> Command { return SetLeading{word(a, 0) == "left" ? 0 : 1}; }},
    };
}

std::vector<Address> instrument_and_control() {
    return {
        {"/drum/height",
         "of the head above the floor",
         {{"HEIGHT", "m", false, true, 0.6, 1.2}},
         [](Arguments a) -> Command { return SetHeadHeight{number(a, 0)}; }},
        {"/membrane",
         "the head that is played: it sounds so, and throws the sticks back so",
         {{"RADIUS", "m", false, true, 0.1, 0.6},
          {"TENSION", "N/m", false, true, 10.0, 100000.0},
          {"DENSITY", "kg/m2", false, true, 0.01, 10.0}},
         [](Arguments a) -> Command {
             return SetMembrane{number(a, 0), number(a, 1), number(a, 2)};
         }},
        {"/mallet",
         "mass of each stick and stiffness K of its tip (felt 1e7 to 1e8, wood 1e9 and more)",
         {{"MASS", "kg", false, true, 0.01, 0.3}, {"STIFFNESS", "", false, true, 1e5, 1e11}},
         [](Arguments a) -> Command {
             return SetMallet{number(a, 0), number(a, 1)};
         }},
        {"/control",
         "what control follows: the joints of a posture, or the sticks' tips (hybrid)",
         {{"TARGET", "", true, true, 0, 0, false, "joints tips"}},
         [](Arguments a) -> Command { return SetTracking{word(a, 0) == "tips"}; }},
        {"/inverse",
         "how inverse kinematics finds the posture: damped least squares, the Jacobian's transpose "
         "or a learnt inverse",
         {{"NAME", "", true, true, 0, 0, false, "dls transpose learnt"}},
         [](Arguments a) -> Command { return SetInverse{word(a, 0)}; }},
        {"/law",
         "how joints are driven: implicit, with forecast, or paper: torque = ks e - kd w",
         {{"LAW", "", true, true, 0, 0, false, "implicit paper"}},
         [](Arguments a) -> Command { return SetLaw{word(a, 0) == "paper"}; }},
        {"/gain",
         "of every joint under the law that holds: its frequency, and damping (1: critical)",
         {{"FREQUENCY", "Hz", false, true, 0.5, 200.0}, {"DAMPING", "", false, false, 0.05, 10.0}},
         [](Arguments a) -> Command {
             return SetGain{number(a, 0), number(a, 1, 1.0)};
         }},
    };
}

}  // namespace

std::vector<Address> manner_addresses() {
    std::vector<Address> all = playing();
    const std::vector<Address> more = instrument_and_control();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace percussionist::osc
