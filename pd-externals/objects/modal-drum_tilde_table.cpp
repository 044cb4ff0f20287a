// What [modal-drum~] understands.
#include "objects/modal-drum_tilde.hpp"

PDX_SETUP(setup_modal0x2ddrum_tilde) {
    using namespace percussionist::pdx;
    namespace modal = percussionist::modal;
    using Drum = percussionist::objects::ModalDrum;

    const modal::Membrane drum;
    const modal::Mallet mallet;
    const modal::Plate plate;
    const modal::Hand hand;
    const auto radius = number("radius", "m").from(0.01).to(5);
    const auto tension = number("tension", "N/m").from(0.1).to(1e6);
    const auto density = number("density", "kg/m^2").from(1e-3).to(100);
    const auto mass = number("mass", "kg").from(1e-5).to(10);
    const auto r = number("r", "m").from(0).to(5);
    const auto theta = number("theta", "rad").from(-100).to(100).by_default(0);
    const auto seconds = [](const char* name) { return number(name, "s").from(1e-3).to(1000); };
    const auto pickup = number("pickup").from(1).to(8).by_default(1);
    const auto speed = [](const char* name) { return number(name, "m/s").from(-100).to(100); };

    Describe<Drum> table =
        describe<Drum>("modal-drum~", "a drum: a membrane's modes struck through felt");
    table
        .creation({radius.by_default(drum.radius), tension.by_default(drum.tension),
                   density.by_default(drum.surface_density),
                   number("pickups").from(1).to(8).by_default(1)})
        .message("bang", {}, "a stroke of 2 m/s", &Drum::bang)
        .message("strike",
                 {number("velocity", "m/s").above(0).to(100), r.or_none(), theta, mass.or_none()},
                 "a stroke, at its very sample", &Drum::strike)
        .message("mallet",
                 {mass, number("hardness", "N/m^a").above(0).to(1e12),
                  number("exponent").from(1).to(5).by_default(mallet.exponent),
                  number("dissipation", "s/m").from(0).to(1e6).by_default(mallet.dissipation),
                  number("stickiness", "N").from(0).to(1e4).by_default(0)},
                 "what strikes from now on (exponent 1: linear)", &Drum::mallet)
        .message("slide", {speed("x"), speed("y")},
                 "how the next strokes move along the head while they touch", &Drum::slide)
        .message("position", {r, theta}, "where strokes fall that do not say", &Drum::position)
        .message("follow", {r, theta},
                 "a felt there follows the second inlet (another place: it glides)", &Drum::follow)
        .message("unfollow", {}, "no felt follows", &Drum::unfollow)
        .message("force-at", {r, theta}, "where the first inlet's force acts", &Drum::force_at)
        .message("hand",
                 {number("hand").from(1).to(4), r, theta,
                  number("area", "m^2").above(0).to(0.1).by_default(hand.area),
                  number("pressure", "Pa").from(0).to(1e6).by_default(hand.pressure)},
                 "a hand comes to lie, moves or presses otherwise", &Drum::hand)
        .message("lift", {number("hand").from(1).to(4).or_none()}, "that hand, or all", &Drum::lift)
        .message("radius", {radius}, "of the head", &Drum::radius)
        .message("tension", {tension}, "of the head", &Drum::tension)
        .message("density", {density}, "mass of the head by its area", &Drum::density)
        .message("bending", {number("stiffness", "N m").from(0).to(1e4)}, "of the skin",
                 &Drum::bending)
        .message("stretch", {number("stiffness", "N/m").from(0).to(1e9)},
                 "of the skin: loud strokes glide in pitch", &Drum::stretch)
        .message("air",
                 {number("density", "kg/m^3").from(0).to(100),
                  number("cavity", "m^3").from(0).to(100).by_default(0)},
                 "which the head moves, and a closed shell's volume", &Drum::air)
        .message("decay", {seconds("t60_low"), seconds("t60_high")},
                 "time to lose 60 dB: lowest mode, and at 2000 Hz (not longer)", &Drum::decay)
        .message(
            "losses",
            {number("constant", "1/s").from(0).to(1e5), number("quadratic", "s").from(0).to(1)},
            "instead: s0 + s1 w^2", &Drum::losses)
        .message("modes", {number("modes").from(1).to(modal::ModalDrum::kMaxModes)},
                 "how many modes sound", &Drum::modes)
        .message("band",
                 {number("low", "Hz").from(0).to(1e5), number("high", "Hz").from(0).to(1e5)},
                 "the modes between", &Drum::band)
        .message("membrane", {}, "a membrane again", &Drum::membrane)
        .message("plate",
                 {radius, number("thickness", "m").from(1e-5).to(0.1),
                  number("young", "Pa").from(1e6).to(1e13).by_default(plate.stiffness),
                  number("density", "kg/m^3").from(1).to(1e5).by_default(plate.density),
                  number("poisson").from(0).to(0.5).by_default(plate.poisson)},
                 "a plate instead, its edge free: a cymbal", &Drum::plate)
        .message("read", {word("file")}, "the modes of a mode file instead", &Drum::read)
        .message("given", {anything("modes")},
                 "modes instead: frequency [Hz], t60 [s], weight, of each", &Drum::given)
        .message("arrays", {word("frequencies"), word("t60s"), word("weights")},
                 "modes instead, out of arrays", &Drum::arrays)
        .message("pickup", {r, theta, pickup}, "hears the head's velocity", &Drum::pickup)
        .message("pickup-position", {r, theta, pickup}, "hears the head's displacement",
                 &Drum::pickup_position)
        .message("pickup-pressure", {number("elevation", "rad").from(-1.6).to(1.6), theta, pickup},
                 "hears the pressure 1 m away, so far off the axis", &Drum::pickup_pressure)
        .message("mute", {seconds("t60").by_default(0.1)}, "all dies, until the next stroke",
                 &Drum::mute)
        .message("reset", {}, "silence at once", &Drum::reset)
        .message("print", {}, "prints modes and settings", &Drum::print)
        .signal_inlet("force on the head [N]")
        .signal_inlet("position of the following felt above the head [m]")
        .signal_outlets("what a pickup hears, -1 to 1", 3);
    add_class(table);
}
