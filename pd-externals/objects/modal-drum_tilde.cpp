// [modal-drum~ RADIUS TENSION DENSITY PICKUPS]: a drum whose head, mallets and hands are simulated;
// see core/modal. Its table is in modal-drum_tilde_table.cpp.
#include "objects/modal-drum_tilde.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "core/modal/mode_file.hpp"

namespace percussionist::objects {

namespace {

double hertz(const modal::ModeBank::Mode& mode) {
    return mode.angular_frequency / (2 * std::numbers::pi);
}

/// Counted from 1 by people.
std::size_t counted(double number) {
    return static_cast<std::size_t>(number) - 1;
}

double number_at(const pdx::Arguments& a, std::size_t i) {
    if (!pdx::is_number(a.atoms()[i])) {
        throw std::invalid_argument("expected numbers, got '" + pdx::to_string(a.atoms()[i]) + "'");
    }
    return a.number(i);
}

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("cannot open '" + path + "'");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

ModalDrum::ModalDrum(pdx::Box& box, const pdx::Arguments& a)
    : Object(box),
      membrane_{.radius = a.number(0), .tension = a.number(1), .surface_density = a.number(2)},
      drum_({.body = membrane_,
             .pickups = std::vector<modal::Pickup>(static_cast<std::size_t>(a.number(3)))},
            48000) {
    retune();
}

void ModalDrum::bang(const pdx::Arguments&) {
    play({.velocity = 2.0, .mallet = mallet_}, position());
}

void ModalDrum::strike(const pdx::Arguments& a) {
    modal::Stroke stroke{.velocity = a.number(0), .mallet = mallet_};
    stroke.mallet.mass = a.has(3) ? a.number(3) : mallet_.mass;
    play(stroke, a.has(1) ? Place{a.number(1), a.number(2)} : position());
}

void ModalDrum::mallet(const pdx::Arguments& a) {
    mallet_ = {a.number(0), a.number(1), a.number(2), a.number(3), a.number(4)};
    if (follows_) {
        follow_place();
    }
}

void ModalDrum::slide(const pdx::Arguments& a) {
    slide_x_ = a.number(0);
    slide_y_ = a.number(1);
}

void ModalDrum::position(const pdx::Arguments& a) {
    position_ = {a.number(0), a.number(1)};
}

void ModalDrum::radius(const pdx::Arguments& a) {
    change(&modal::Membrane::radius, a.number(0));
}
void ModalDrum::tension(const pdx::Arguments& a) {
    change(&modal::Membrane::tension, a.number(0));
}
void ModalDrum::density(const pdx::Arguments& a) {
    change(&modal::Membrane::surface_density, a.number(0));
}
void ModalDrum::bending(const pdx::Arguments& a) {
    change(&modal::Membrane::bending, a.number(0));
}
void ModalDrum::stretch(const pdx::Arguments& a) {
    change(&modal::Membrane::stretch, a.number(0));
}
void ModalDrum::air(const pdx::Arguments& a) {
    auto membrane = membrane_;
    membrane.air_density = a.number(0);
    membrane.cavity = a.number(1);
    use(membrane);
}

void ModalDrum::plate(const pdx::Arguments& a) {
    tune(modal::Plate{a.number(0), a.number(1), a.number(2), a.number(3), a.number(4)}, loss());
}

void ModalDrum::membrane(const pdx::Arguments&) {
    use(membrane_);
}

void ModalDrum::read(const pdx::Arguments& a) {
    tune(modal::parse_modes(text_of(find_file(a.word(0)))), loss());
}

void ModalDrum::given(const pdx::Arguments& a) {
    modal::GivenModes given;
    given.name = "given";
    given.origin = "given by message";
    given.radius = drum_.head().resonator().radius();
    if (a.size() == 0 || a.size() % 3 != 0) {
        throw std::invalid_argument("expected FREQUENCY [Hz] T60 [s] WEIGHT, again and again");
    }
    for (std::size_t i = 0; i < a.size(); i += 3) {
        given.modes.push_back({number_at(a, i), number_at(a, i + 1), 0, {number_at(a, i + 2)}});
    }
    tune(given, loss());
}

void ModalDrum::arrays(const pdx::Arguments& a) {
    const auto frequencies = pdx::array_values(a.word(0));
    const auto t60s = pdx::array_values(a.word(1));
    const auto weights = pdx::array_values(a.word(2));
    if (frequencies.size() != t60s.size() || t60s.size() != weights.size()) {
        throw std::invalid_argument("expected three arrays of one length");
    }
    modal::GivenModes given;
    given.name = a.word(0);
    given.origin = "given by arrays";
    given.radius = drum_.head().resonator().radius();
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        given.modes.push_back({frequencies[i], t60s[i], 0, {weights[i]}});
    }
    tune(given, loss());
}

void ModalDrum::decay(const pdx::Arguments& a) {
    modal::Decay decay;
    decay.t60_low = a.number(0);
    decay.t60_high = a.number(1);
    tune(drum_.settings().body, decay);
}

void ModalDrum::losses(const pdx::Arguments& a) {
    tune(drum_.settings().body, modal::PhysicalLoss{a.number(0), a.number(1)});
}

void ModalDrum::modes(const pdx::Arguments& a) {
    drum_.choose({.count = static_cast<std::size_t>(a.number(0)), .skip = 0});
}

void ModalDrum::band(const pdx::Arguments& a) {
    drum_.choose(modal::band(drum_.settings().body, a.number(0), a.number(1)));
}

void ModalDrum::pickup(const pdx::Arguments& a) {
    listen(modal::Pickup::Hears::velocity, a);
}
void ModalDrum::pickup_position(const pdx::Arguments& a) {
    listen(modal::Pickup::Hears::position, a);
}
void ModalDrum::pickup_pressure(const pdx::Arguments& a) {
    modal::Pickup pickup;
    pickup.hears = modal::Pickup::Hears::pressure;
    pickup.elevation = a.number(0);
    pickup.theta = a.number(1);
    place(counted(a.number(2)), pickup);
}

void ModalDrum::listen(modal::Pickup::Hears hears, const pdx::Arguments& a) {
    modal::Pickup pickup;
    pickup.hears = hears;
    pickup.r = a.number(0);
    pickup.theta = a.number(1);
    place(counted(a.number(2)), pickup);
}

void ModalDrum::place(std::size_t i, const modal::Pickup& pickup) {
    drum_.set_pickup(i, pickup);
    placed_pickups_.at(i) = true;
}

void ModalDrum::hand(const pdx::Arguments& a) {
    lay(counted(a.number(0)), {a.number(1), a.number(2), a.number(3), a.number(4)});
}

void ModalDrum::lift(const pdx::Arguments& a) {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        if (!a.has(0) || counted(a.number(0)) == i) {
            lay(i, {.pressure = 0.0});
        }
    }
}

void ModalDrum::lay(std::size_t i, const modal::Hand& hand) {
    drum_.lay(i, hand);
    hands_[i] = hand;
}

void ModalDrum::follow(const pdx::Arguments& a) {
    follows_ = Place{a.number(0), a.number(1)};
    follow_place();
}

void ModalDrum::unfollow(const pdx::Arguments&) {
    follows_.reset();
    drum_.unfollow();
}

void ModalDrum::follow_place() {
    drum_.follow(follows_->r, follows_->theta, mallet_);
}

void ModalDrum::force_at(const pdx::Arguments& a) {
    force_at_ = {a.number(0), a.number(1)};
    drum_.force_at(force_at_.r, force_at_.theta);
}

void ModalDrum::mute(const pdx::Arguments& a) {
    drum_.mute(a.number(0));
}

void ModalDrum::reset(const pdx::Arguments&) {
    waiting_.clear();
    follows_.reset();
    drum_.reset();
}

template <class... Numbers>
void ModalDrum::say(const char* format, Numbers... numbers) const {
    char text[200];
    std::snprintf(text, sizeof text, format, numbers...);
    post(text);
}

void ModalDrum::print(const pdx::Arguments&) {
    const auto& s = drum_.settings();
    const auto all = drum_.head().resonator().oscillators();
    say("%.0f modes from %.1f to %.0f Hz", static_cast<double>(all.size()), hertz(all.front()),
        hertz(all.back()));
    if (const auto* m = std::get_if<modal::Membrane>(&s.body)) {
        say("radius %g m, tension %g N/m, density %g kg/m^2", m->radius, m->tension,
            m->surface_density);
        say("bending %g N m, air %g kg/m^3, cavity %g m^3, stretch %g N/m", m->bending,
            m->air_density, m->cavity, m->stretch);
    } else if (const auto* p = std::get_if<modal::Plate>(&s.body)) {
        say("plate: radius %g m, thickness %g m", p->radius, p->thickness);
    } else if (const auto* g = std::get_if<modal::GivenModes>(&s.body)) {
        post(g->name + ", " + g->origin);
    }
    say("mallet %g kg, %g N/m^a, a %g, %g s/m, %g N", mallet_.mass, mallet_.stiffness,
        mallet_.exponent, mallet_.dissipation, mallet_.stickiness);
    say("position %g m %g rad", position().r, position().theta);
}

void ModalDrum::prepare(double sample_rate, std::size_t) {
    if (sample_rate != drum_.head().sample_rate()) {
        drum_ = modal::ModalDrum(drum_.settings(), sample_rate);
        drum_.force_at(force_at_.r, force_at_.theta);
        for (std::size_t i = 0; i < hands_.size(); ++i) {
            if (hands_[i]) {
                drum_.lay(i, *hands_[i]);
            }
        }
        if (follows_) {
            follow_place();
        }
    }
}

void ModalDrum::process(const pdx::Block& block) noexcept {
    waiting_.take(block, [this](std::size_t offset, const modal::Stroke& stroke) {
        drum_.strike(offset, stroke);
    });
    drum_.process(modal::DrumSignals<pdx::Sample>{.outputs = block.outputs,
                                                  .size = block.size,
                                                  .force = block.inputs[0],
                                                  .position = block.inputs[1]});
}

/// Where not told otherwise, strokes and pickups keep their place on the head as it grows.
ModalDrum::Place ModalDrum::position() const {
    return position_.value_or(Place{0.3 * drum_.head().resonator().radius(), 0.0});
}

const modal::Loss& ModalDrum::loss() const {
    return drum_.settings().loss;
}

void ModalDrum::change(double modal::Membrane::*field, double value) {
    auto membrane = membrane_;
    membrane.*field = value;
    use(membrane);
}

void ModalDrum::use(const modal::Membrane& membrane) {
    tune(membrane, loss());
    membrane_ = membrane;
}

void ModalDrum::tune(const modal::Body& body, const modal::Loss& loss) {
    drum_.tune(body, loss);
    retune();
}

void ModalDrum::retune() {
    const double radius = drum_.head().resonator().radius();
    if (radius == pickups_of_) {
        return;
    }
    pickups_of_ = radius;
    for (std::size_t i = 0; i < drum_.settings().pickups.size(); ++i) {
        if (!placed_pickups_.at(i)) {
            auto pickup = drum_.settings().pickups[i];
            pickup.r = 0.6 * radius;
            pickup.theta = 2.0 + static_cast<double>(i);
            drum_.set_pickup(i, pickup);
        }
    }
    drum_.force_at(force_at_.r, force_at_.theta);
}

void ModalDrum::play(modal::Stroke stroke, const Place& place) {
    stroke.r = place.r;
    stroke.theta = place.theta;
    stroke.slide_x = slide_x_;
    stroke.slide_y = slide_y_;
    check(stroke);
    if (!waiting_.push(now(), stroke)) {
        throw std::runtime_error("too many strokes wait; are signals on?");
    }
}

}  // namespace percussionist::objects
