// The drumhead under the sticks of the simulation, or another thing that is struck: modes (of a
// membrane, a plate, or given) and felt, integrated at audio rate inside each step of the body.
//
// A step of ODE is too long for a contact of 5 ms (its peak force would vary by 17 % with the phase
// of the steps). So while a tip is near, tip, felt and head are moved together at some 48 kHz
// (core/modal/struck_head.hpp), the tip being a mass: the effective mass of body and stick
// along the head's normal, accelerated by what else moves it. ODE is given the impulse of the whole
// step. During a contact the tip's place is that of the fine integration, its velocity at the
// beginning of each step is ODE's.
//
// Frictionless: the head pushes along its normal only. Frame: the head's own, origin in its middle,
// z out of it; a tip that comes from below passes. After construction no allocation but that of
// `contacts`; one thread; deterministic.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/modal/struck_head.hpp"
#include "sim/contact_event.hpp"

namespace percussionist::sim {

struct DrumheadOptions {
    modal::Membrane membrane;
    modal::Decay decay;
    modal::Mallet tip;  ///< felt of the stick's tip; its mass is the simulation's, not this one
    std::size_t modes = 64;    ///< enough for the force: those above add no more give than felt has
    double fine_rate = 48000;  ///< about which rate contacts are integrated [Hz]
};

/// A stick's tip at the beginning of a step.
struct TouchingTip {
    linear::Vector3 place = linear::Vector3::Zero();     ///< of its lowest point [m]
    linear::Vector3 velocity = linear::Vector3::Zero();  ///< [m/s]
    double mass = 0.012;        ///< effective, in a step of the simulation with its springs [kg]
    double bare_mass = 0.012;   ///< effective, of body and stick alone [kg]
    double acceleration = 0.0;  ///< along z, of all but the head [m/s^2]
};

class Drumhead {
  public:
    /// h [s], the step of the body's simulation. Throws std::invalid_argument.
    Drumhead(const DrumheadOptions& options, double h);
    /// Any other body, struck with such felt.
    Drumhead(modal::Resonator body, const modal::Mallet& felt, double fine_rate, double h);

    /// Whether a tip may touch within the coming step, or does. Beyond the rim it passes by.
    [[nodiscard]] bool near(const TouchingTip& tip) const;

    /// From `time` to time + h, the tips by body::Hand. Returns the impulse on each tip along z
    /// [N s]; contacts that have ended are appended.
    std::array<double, 2> step(double time, const std::array<TouchingTip, 2>& tips,
                               std::vector<ContactEvent>& contacts);

    /// The head alone, to change while it sounds. Throws std::invalid_argument.
    void tune(const modal::Membrane& membrane, const modal::Decay& decay);
    /// Of the felt; a contact under way goes on with it. Throws std::invalid_argument.
    void set_tip_stiffness(double stiffness);
    /// Another felt of one tip alone, its mass aside, which modal::check() accepts; a contact under
    /// way goes on with it.
    void set_felt(std::size_t tip, const modal::Mallet& felt) { strikers_[tip].mallet = felt; }
    [[nodiscard]] bool touches(std::size_t tip) const { return hands_[tip].phase != Phase::away; }

  private:
    /// A stroke is told when it is over or has lasted long; a tip still pressed in by then begins
    /// no other until it has left.
    enum class Phase { away, touching, told };
    struct Hand {
        Phase phase = Phase::away;
        ContactEvent event;         ///< of the stroke, while it touches
        double last_touch = 0.0;    ///< [s]
        double last_stroke = -1e9;  ///< when the last one that was no re-contact began [s]
        linear::Vector3 placed =
            linear::Vector3::Constant(1e9);  ///< for which modes were evaluated
    };
    void take_up(std::size_t hand, const TouchingTip& tip);
    /// A tip at the beginning of a sample: above the head as it is [m], upwards [m/s].
    struct Approach {
        double height = 0.0, velocity = 0.0;
    };
    void sample(double time, std::size_t hand, const TouchingTip& tip, const Approach& before);
    void begin(std::size_t hand, const TouchingTip& tip, double instant);
    void end_if_over(Hand& hand, double time, std::vector<ContactEvent>& contacts) const;

    modal::Mallet felt_;
    int samples_;  ///< in a step
    double period_;
    modal::StruckHead head_;
    std::array<modal::Striker, 2> strikers_;
    std::array<Hand, 2> hands_;
    std::array<double, 2> impulses_{};
    bool at_rest_ = true;
};

}  // namespace percussionist::sim
