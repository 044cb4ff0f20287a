// [modal-drum~ RADIUS TENSION DENSITY]: a drum whose head and mallet are simulated; see core/modal.
#include <cstdio>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/modal/modal_drum.hpp"
#include "pdx/object.hpp"
#include "pdx/timed_queue.hpp"

namespace {

using namespace percussionist::pdx;
namespace modal = percussionist::modal;

struct Place {
    double r;      ///< [m]
    double theta;  ///< [rad]
};

class ModalDrum : public Object {
  public:
    ModalDrum(Box& box, const Arguments& creation) : Object(box), drum_({}, 48000) {
        tune({creation.number(0), creation.number(1), creation.number(2)}, drum_.settings().decay);
    }

    void bang(const Arguments&) { play({.velocity = 2.0, .mallet = mallet_}, position()); }

    void strike(const Arguments& a) {
        modal::Stroke stroke{.velocity = a.number(0), .mallet = mallet_};
        stroke.mallet.mass = a.has(3) ? a.number(3) : mallet_.mass;
        play(stroke, a.has(1) ? Place{a.number(1), a.number(2)} : position());
    }

    void mallet(const Arguments& a) {
        mallet_ = {a.number(0), a.number(1), a.number(2), a.number(3)};
    }
    void position(const Arguments& a) { position_ = {a.number(0), a.number(1)}; }

    void radius(const Arguments& a) {
        auto membrane = drum_.settings().membrane;
        membrane.radius = a.number(0);
        tune(membrane, drum_.settings().decay);
    }
    void tension(const Arguments& a) {
        auto membrane = drum_.settings().membrane;
        membrane.tension = a.number(0);
        tune(membrane, drum_.settings().decay);
    }
    void density(const Arguments& a) {
        auto membrane = drum_.settings().membrane;
        membrane.surface_density = a.number(0);
        tune(membrane, drum_.settings().decay);
    }
    void decay(const Arguments& a) {
        auto decay = drum_.settings().decay;
        decay.t60_low = a.number(0);
        decay.t60_high = a.number(1);
        tune(drum_.settings().membrane, decay);
    }
    void modes(const Arguments& a) { drum_.set_modes(static_cast<std::size_t>(a.number(0))); }
    void pickup(const Arguments& a) {
        pickup_ = {a.number(0), a.number(1)};
        drum_.set_pickup(pickup_->r, pickup_->theta);
    }
    void mute(const Arguments& a) { drum_.mute(a.number(0)); }

    void reset(const Arguments&) {
        waiting_.clear();
        drum_.reset();
    }

    void print(const Arguments&) {
        const auto& s = drum_.settings();
        const auto& all = drum_.head().modes();
        say("%.0f modes from %.1f to %.0f Hz", static_cast<double>(all.size()), hertz(all.front()),
            hertz(all.back()));
        say("radius %g m, tension %g N/m, density %g kg/m^2", s.membrane.radius, s.membrane.tension,
            s.membrane.surface_density);
        say("decay %g s low, %g s at %g Hz", s.decay.t60_low, s.decay.t60_high,
            s.decay.high_frequency);
        say("mallet %g kg, %g N/m^a, a %g, %g s/m", mallet_.mass, mallet_.stiffness,
            mallet_.exponent, mallet_.dissipation);
        say("position %g m %g rad, pickup %g m %g rad", position().r, position().theta, s.pickup_r,
            s.pickup_theta);
    }

    void prepare(double sample_rate, std::size_t) override {
        if (sample_rate != drum_.head().sample_rate()) {
            drum_ = modal::ModalDrum(drum_.settings(), sample_rate);
        }
    }

    void process(const Block& block) noexcept override {
        waiting_.take(block, [this](std::size_t offset, const modal::Stroke& stroke) {
            drum_.strike(offset, stroke);
        });
        drum_.process(std::span(block.outputs[0], block.size));
    }

  private:
    template <class... Numbers>
    void say(const char* format, Numbers... numbers) const {
        char text[200];
        std::snprintf(text, sizeof text, format, numbers...);
        post(text);
    }

    static double hertz(const modal::MembraneMode& mode) {
        return mode.angular_frequency / (2 * std::numbers::pi);
    }

    /// Where not told otherwise, strokes and pickup keep their place on the head as it grows.
    Place position() const {
        return position_.value_or(Place{0.3 * drum_.settings().membrane.radius, 0.0});
    }

    void tune(const modal::Membrane& membrane, const modal::Decay& decay) {
        drum_.tune(membrane, decay);
        if (!pickup_) {
            drum_.set_pickup(0.6 * membrane.radius, 2.0);
        }
    }

    void play(modal::Stroke stroke, const Place& place) {
        stroke.r = place.r;
        stroke.theta = place.theta;
        check(stroke);
        if (!waiting_.push(now(), stroke)) {
            throw std::runtime_error("too many strokes wait; are signals on?");
        }
    }

    modal::ModalDrum drum_;
    modal::Mallet mallet_;
    std::optional<Place> position_, pickup_;
    TimedQueue<modal::Stroke, modal::ModalDrum::kQueue> waiting_;
};

}  // namespace

PDX_SETUP(setup_modal0x2ddrum_tilde) {
    const modal::Membrane drum;
    const modal::Mallet mallet;
    const auto radius = number("radius", "m").from(0.01).to(5);
    const auto tension = number("tension", "N/m").from(0.1).to(1e6);
    const auto density = number("density", "kg/m^2").from(1e-3).to(100);
    const auto mass = number("mass", "kg").from(1e-5).to(10);
    const auto r = number("r", "m").from(0).to(5);
    const auto theta = number("theta", "rad").by_default(0);
    const auto seconds = [](const char* name) { return number(name, "s").from(1e-3).to(1000); };

    add_class(
        describe<ModalDrum>("modal-drum~", "a drum: a membrane's modes struck through felt")
            .creation({radius.by_default(drum.radius), tension.by_default(drum.tension),
                       density.by_default(drum.surface_density)})
            .message("bang", {}, "a stroke of 2 m/s", &ModalDrum::bang)
            .message(
                "strike",
                {number("velocity", "m/s").above(0).to(100), r.or_none(), theta, mass.or_none()},
                "a stroke, at its very sample", &ModalDrum::strike)
            .message("mallet",
                     {mass, number("hardness", "N/m^a").above(0).to(1e12),
                      number("exponent").from(1).to(5).by_default(mallet.exponent),
                      number("dissipation", "s/m").from(0).to(1e6).by_default(mallet.dissipation)},
                     "what strikes, from the next stroke on", &ModalDrum::mallet)
            .message("position", {r, theta}, "where strokes fall that do not say",
                     &ModalDrum::position)
            .message("radius", {radius}, "of the head", &ModalDrum::radius)
            .message("tension", {tension}, "of the head", &ModalDrum::tension)
            .message("density", {density}, "mass of the head by its area", &ModalDrum::density)
            .message("decay", {seconds("t60_low"), seconds("t60_high")},
                     "time to lose 60 dB: lowest mode, and at 2000 Hz (not longer)",
                     &ModalDrum::decay)
            .message("modes", {number("modes").from(1).to(modal::ModalDrum::kMaxModes)},
                     "how many modes sound", &ModalDrum::modes)
            .message("pickup", {r, theta}, "where the head is listened to", &ModalDrum::pickup)
            .message("mute", {seconds("t60").by_default(0.1)},
                     "a hand on the head, until the next stroke", &ModalDrum::mute)
            .message("reset", {}, "silence at once", &ModalDrum::reset)
            .message("print", {}, "prints modes and settings", &ModalDrum::print)
            .signal_outlet("the head's velocity, -1 to 1"));
}
