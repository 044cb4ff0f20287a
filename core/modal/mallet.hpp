// A mallet and its felt: how hard it pushes back when pressed into a head.
//
// The contact is Hunt and Crossley's, f = K d^a (1 + mu d'), d the compression (positive inside),
// never pulling. Over one step of h seconds, in which the compression goes from d to d + y, the
// force is constant and
//     f = (V(d + y) - V(d)) / y  *  max(0, 1 + mu y / h),     V(d) = K max(d, 0)^(a + 1) / (a + 1)
// The first factor is the discrete gradient of the potential: its work is the change of V to the
// last digit. The second only ever adds dissipation. The bodies answer the force by moving
//     y = y_free - compliance * f
// and both together have one solution: the left side minus the right grows with y and, for a >= 1,
// is convex, so that Newton's method from any start is on the right of the solution after one step
// and from there falls to it without overshooting.
// Sources: Hunt and Crossley 1975; Papetti, Avanzini, Rocchesso 2011; Chatziioannou and van
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
};

/// Throws std::invalid_argument naming the field unless mass and stiffness are above 0 (stiffness
/// up to 1e12), the exponent is within 1 to 5 and the dissipation is 0 or more, all finite.
void check(const Mallet& mallet);

/// V(d) [J].
double contact_potential(const Mallet& mallet, double compression) noexcept;

/// The step in which a force is sought.
struct ContactStep {
    double compression = 0.0;  ///< at its beginning, d [m]
    double free_change = 0.0;  ///< of the compression if there were no force, y_free [m]
    double compliance = 0.0;   ///< what a constant force of 1 N takes off it, > 0 [m/N]
    double duration = 0.0;     ///< h [s]
};

/// The force [N], 0 or more and finite whatever comes in. `guess` (the force of the step before)
/// saves iterations and changes the result by no more than rounding.
double contact_force(const Mallet& mallet, const ContactStep& step, double guess) noexcept;

}  // namespace percussionist::modal
