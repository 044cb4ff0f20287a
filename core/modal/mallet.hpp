// A mallet and its felt: how hard it pushes back when pressed into a head.
//
// The contact is Hunt and Crossley's, f = K d^a (1 + mu d'), d the compression (positive inside),
// never pulling. Over one step of h seconds, in which the compression goes from d to d + y and its
// rate v from v0 to v1 = 2 y / h - v0, the force is constant and
//     f = (V(d + y) - V(d)) / y * damping,     V(d) = K max(d, 0)^(a + 1) / (a + 1)
// The first factor is the discrete gradient of the potential: its work is the change of V to the
// last digit. While v keeps its sign, the second is the mean of 1 + mu v for which a mass thrown at
// a wall loses what the law itself takes from it, whatever the length of the step:
//     damping = (v1^2 - v0^2) / 2  over  the integral of v / (1 + mu v) dv from v0 to v1
// and else 1 + mu y / h. It is at least 1 inwards and at most 1 outwards: it only ever takes
// energy. The bodies answer the force by moving
//     y = y_free - compliance * f
// and both together have one solution, for the left side minus the right grows with y: Newton's
// method, kept within a bracket. With a = 1 and mu = 0, the cheap linear contact, it is found at
// once. Sources: Hunt and Crossley 1975; Marhefka and Orin 1999; Papetti, Avanzini, Rocchesso 2011;
// Chatziioannou and van Walstijn, "Energy conserving schemes for the simulation of musical
// instrument contact dynamics", 2015. The mean of the damping is our own.
//
// Sticky surfaces that have touched pull back with up to `stickiness` newtons while they part,
// until kTackReach lies between them: a dry friction along the normal, which only ever takes
// energy. Sources: Hunt and Crossley 1975; Papetti, Avanzini, Rocchesso 2011; Chatziioannou and van
// Walstijn, "Energy conserving schemes for the simulation of musical instrument contact dynamics",
// 2015.
//
// Pure and noexcept but for check(): all may be called in the audio thread.
#pragma once

namespace percussionist::modal {

/// The default is our choice, not a measurement: about what the tip of a 45 g stick held at its end
/// has of its mass, and a hard felt. On the default membrane it stays for 5 to 7 ms, the shorter
/// the harder the stroke.
struct Mallet {
    double mass = 0.012;       ///< what the head feels of the stick [kg]
    double stiffness = 1.0e8;  ///< K [N/m^a]
    double exponent = 2.3;     ///< a: 1.5 for hard balls (Hertz), 2 to 4 for felt
    double dissipation = 0.3;  ///< mu [s/m]; 0 loses nothing
    double stickiness = 0.0;   ///< pull at which sticking surfaces part [N]
};

/// How far sticky surfaces pull each other when apart [m].
constexpr double kTackReach = 3e-4;

/// Throws std::invalid_argument naming the field unless mass and stiffness are above 0 (stiffness
/// up to 1e12), the exponent is within 1 to 5 and dissipation and stickiness are 0 or more, all
/// finite.
void check(const Mallet& mallet);

/// V(d) [J].
double contact_potential(const Mallet& mallet, double compression) noexcept;

/// The step in which a force is sought.
struct ContactStep {
    double compression = 0.0;  ///< at its beginning, d [m]
    double free_change = 0.0;  ///< of the compression if there were no force, y_free [m]
    double compliance = 0.0;   ///< what a constant force of 1 N takes off it, > 0 [m/N]
    double duration = 0.0;     ///< h [s]
    double rate = 0.0;         ///< of the compression at its beginning, v0 [m/s]
    bool stuck = false;        ///< the surfaces have touched and are not yet parted
};

/// The force [N], finite whatever comes in, and 0 or more unless stuck. `guess` (the force of the
/// step before) saves iterations and changes the result by no more than rounding.
double contact_force(const Mallet& mallet, const ContactStep& step, double guess) noexcept;

/// Whether under this force a lossy felt goes from in to out so quickly that the mean of the
/// damping within the step is a guess: only shorter steps tell.
bool turns_hastily(const Mallet& mallet, const ContactStep& step, double force) noexcept;

}  // namespace percussionist::modal
