// [gesture-features]: poses in, strokes and gestures out; see core/motion/stick_gestures.hpp.
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "core/motion/stick_gestures.hpp"
#include "pdx/object.hpp"

namespace {

using namespace percussionist::pdx;
namespace motion = percussionist::motion;
namespace linear = percussionist::linear;
using motion::Vector3;

enum Outlet : std::size_t { kStrike, kDetail, kFeature, kHand, kStatus };

class GestureFeatures : public Object {
  public:
    GestureFeatures(Box& box, const Arguments&)
        : Object(box), due_(*this, [this] { send_due(); }) {}

    void pose(const Arguments& a) {
        const linear::Quaternion q(a.number(4), a.number(5), a.number(6), a.number(7));
        if (std::abs(q.norm() - 1.0) > 0.01) {
            throw std::invalid_argument("expected a unit quaternion");
        }
        take(gestures_.add(a.integer(0), {now(), {vector(a, 1), q.normalized()}}));
    }

    void stick(const Arguments& a) {
        change([&](auto& s) { s.stick = a.integer(0); });
    }
    void frame(const Arguments& a) {
        change([&](auto& s) { s.frame = a.integer(0); });
    }
    void hand(const Arguments& a) {
        change([&](auto& s) {
            s.hand = a.integer(0);
            s.full_press = a.number(1);
            s.touch = a.number(2);
        });
    }
    void tip(const Arguments& a) {
        const auto end = static_cast<std::size_t>(a.integer(0)) - 1;
        if (!a.has(1) && end == 0) {
            throw std::invalid_argument("expected the place of end 1, which is always there");
        }
        if (a.has(1) && !a.has(3)) {
            throw std::invalid_argument("expected x, y and z [m], or none of them");
        }
        change([&](auto& s) {
            s.tips.at(end) = a.has(3) ? std::optional(vector(a, 1)) : std::nullopt;
        });
    }
    void radius(const Arguments& a) {
        change([&](auto& s) { s.plane.tip_radius = a.number(0); });
    }
    void drum(const Arguments& a) {
        change([&](auto& s) { s.plane.drum_radius = a.number(0); });
    }
    void ahead(const Arguments& a) {
        change([&](auto& s) {
            s.plane.ahead = a.number(0);
            s.plane.hardest_stop = a.number(1);
        });
    }
    void latency(const Arguments& a) { latency_ = a.number(0); }
    void softest(const Arguments& a) {
        change([&](auto& s) {
            s.plane.least_speed = a.number(0);
            s.free.least_speed = a.number(1);
            s.free.least_deceleration = a.number(2);
        });
    }
    void window(const Arguments& a) {
        change([&](auto& s) { s.fit.window = a.number(0); });
    }
    void detect(const Arguments& a) {
        const std::string word = a.word(0);
        if (word != "plane" && word != "free" && word != "none") {
            throw std::invalid_argument("expected plane, free or none, got " + word);
        }
        if (word == "plane" && !gestures_.drum()) {
            throw std::invalid_argument("expected a plane first: plane, or taps and fit");
        }
        detect(word == "plane"  ? motion::Detection::kPlane
               : word == "free" ? motion::Detection::kFree
                                : motion::Detection::kNone);
    }

    void plane(const Arguments& a) {
        const Vector3 normal = vector(a, 3);
        if (!(normal.norm() > 1e-6)) {
            throw std::invalid_argument("expected a normal that is not 0");
        }
        // Three points on the plane give it the axes that taps would.
        const Vector3 middle = vector(a, 0), z = normal.normalized();
        const Vector3 u = z.unitOrthogonal(), v = z.cross(u);
        const Vector3 taps[] = {middle + u, middle - 0.5 * (u - v), middle - 0.5 * (u + v)};
        gestures_.set_drum(motion::fit_plane(taps, middle + z, 0.0).world_from_drum);
        detect(motion::Detection::kPlane);
        tell_plane(0.0);
    }
    void tap(const Arguments&) { tell_taps(gestures_.tap()); }
    void calibrate(const Arguments& a) {
        calibrating_ = a.number(0) != 0.0;
        if (calibrating_) {
            gestures_.clear_taps();
            detect(motion::Detection::kFree);
            tell_taps(0);
        } else {
            fit(a);
        }
    }
    void fit(const Arguments&) {
        const auto fitted = gestures_.fit_drum();
        detect(motion::Detection::kPlane);
        tell_plane(fitted.residual);
    }
    void reset(const Arguments&) {
        auto settings = gestures_.settings();
        if (settings.detection == motion::Detection::kPlane) {
            settings.detection = motion::Detection::kFree;
        }
        gestures_ = motion::StickGestures(settings);
        calibrating_ = false;
        strikes_.clear();
    }
    void print(const Arguments&) {
        const Atom counts[] = {static_cast<double>(gestures_.repeats()),
                               static_cast<double>(gestures_.jumps())};
        send(kStatus, "dropped", counts);
    }

  private:
    struct Strike {
        double time;
        std::array<double, 3> stroke;  // velocity [m/s], r [m], theta [rad]
        std::size_t size;
    };

    static Vector3 vector(const Arguments& a, std::size_t first) {
        return {a.number(first), a.number(first + 1), a.number(first + 2)};
    }
    template <class Change>
    void change(Change apply) {
        auto settings = gestures_.settings();
        apply(settings);
        gestures_.set(settings);
    }
    void detect(motion::Detection detection) {
        change([&](auto& s) { s.detection = detection; });
    }

    void take(const motion::StickEvents& events) {
        for (std::size_t end = 0; end < 2; ++end) {
            if (events.plane[end]) {
                take(*events.plane[end], end + 1);
            }
            if (events.free[end]) {
                take(*events.free[end], end + 1);
            }
        }
        if (events.gesture) {
            tell(*events.gesture);
        }
        if (events.press) {
            const Atom damp[] = {events.press->place.r, events.press->place.theta,
                                 events.press->pressure};
            send(kHand, "damp", damp);
        }
    }

    void take(const motion::PlaneStrike& s, std::size_t end) {
        const Atom detail[] = {static_cast<double>(end), static_cast<double>(s.side),
                               s.time - now(),           s.velocity.x(),
                               s.velocity.y(),           s.velocity.z()};
        send(kDetail, "plane", detail);
        schedule({s.time - latency_, {s.speed, s.place.r, s.place.theta}, 3});
    }

    void take(const motion::FreeStrike& s, std::size_t end) {
        const Atom detail[] = {static_cast<double>(end),
                               s.time - now(),
                               s.peak_time - now(),
                               s.deceleration,
                               s.direction.x(),
                               s.direction.y(),
                               s.direction.z(),
                               s.place.x(),
                               s.place.y(),
                               s.place.z()};
        send(kDetail, "free", detail);
        schedule({s.time - latency_, {s.speed, 0.0, 0.0}, 1});
        if (calibrating_ && end == 1) {
            tell_taps(gestures_.tap(s.place));
        }
    }

    void schedule(const Strike& strike) {
        const auto place =
            std::upper_bound(strikes_.begin(), strikes_.end(), strike.time,
                             [](double time, const Strike& other) { return time < other.time; });
        strikes_.insert(place, strike);
        send_due();
    }
    void send_due() {
        while (!strikes_.empty() && strikes_.front().time <= now() + 1e-9) {
            const Strike strike = strikes_.front();
            strikes_.pop_front();
            const Atom atoms[] = {strike.stroke[0], strike.stroke[1], strike.stroke[2]};
            send(kStrike, "strike", std::span(atoms).first(strike.size));
        }
        if (!strikes_.empty()) {
            due_.at(strikes_.front().time);
        }
    }

    void tell(const char* name, const Vector3& v) const {
        const Atom atoms[] = {v.x(), v.y(), v.z()};
        send(kFeature, name, atoms);
    }
    void tell(const char* name, double value) const {
        const Atom atoms[] = {value};
        send(kFeature, name, atoms);
    }
    void tell(const motion::Gesture& g) const {
        tell("delay", g.delay);
        tell("position", g.position);
        tell("velocity", g.velocity);
        tell("acceleration", g.acceleration);
        tell("jerk", g.jerk);
        tell("direction", g.direction);
        tell("angular-velocity", g.angular_velocity);
        tell("speed", g.speed);
        tell("turning", g.turning);
        tell("curvature", g.curvature);
    }
    void tell_taps(std::size_t count) const {
        const Atom atoms[] = {static_cast<double>(count)};
        send(kStatus, "taps", atoms);
    }
    void tell_plane(double residual) const {
        const auto& drum = *gestures_.drum();
        const Vector3 z = drum.orientation * Vector3::UnitZ();
        const Atom atoms[] = {
            drum.position.x(), drum.position.y(), drum.position.z(), z.x(), z.y(), z.z(), residual};
        send(kStatus, "plane", atoms);
    }

    motion::StickGestures gestures_;
    bool calibrating_ = false;
    double latency_ = 0.0;
    std::deque<Strike> strikes_;
    Clock due_;
};

}  // namespace

PDX_SETUP(setup_gesture0x2dfeatures) {
    const auto station = number("station").from(1).to(4);
    const auto or_none = number("station").from(0).to(4);
    const auto metres = [](const char* name) { return number(name, "m").from(-10).to(10); };
    const auto part = [](const char* name) { return number(name).from(-1.01).to(1.01); };
    const motion::StickGesturesSettings usual;

    add_class(
        describe<GestureFeatures>("gesture-features", "poses in, strikes and gestures out")
            .message("pose",
                     {station, metres("x"), metres("y"), metres("z"), part("qw"), part("qx"),
                      part("qy"), part("qz")},
                     "where a receiver is now, as fastrak~ tells it", &GestureFeatures::pose)
            .message("stick", {station}, "which receiver is on the stick", &GestureFeatures::stick)
            .message("frame", {or_none},
                     "which one all is seen from: on the player or the frame (0: the transmitter)",
                     &GestureFeatures::frame)
            .message("hand",
                     {or_none, number("press", "m").from(1e-4).to(0.2).by_default(0.01),
                      number("touch", "m").from(0).to(0.3).by_default(0.03)},
                     "which one damps, how far in is a pressure of 1, how far from the head it is "
                     "when it touches",
                     &GestureFeatures::hand)
            .message(
                "tip",
                {number("end").from(1).to(2), number("x", "m").from(-1).to(1).or_none(),
                 number("y", "m").from(-1).to(1).or_none(),
                 number("z", "m").from(-1).to(1).or_none()},
                "the middle of the stick's round end, from its receiver (without: no such end)",
                &GestureFeatures::tip)
            .message("radius", {number("radius", "m").from(0).to(0.1)}, "of the stick's round ends",
                     &GestureFeatures::radius)
            .message("drum", {number("drum", "m").from(0).to(2)},
                     "its radius: beyond is nothing (0: no limit)", &GestureFeatures::drum)
            .message("detect", {word("how")}, "strikes: plane, free or none",
                     &GestureFeatures::detect)
            .message(
                "plane",
                {metres("x"), metres("y"), metres("z"), metres("nx"), metres("ny"), metres("nz")},
                "the head: its middle, and out of it", &GestureFeatures::plane)
            .message("calibrate", {number("on").from(0).to(1)},
                     "1: every tap on a real surface is kept, 0: the head is where they were",
                     &GestureFeatures::calibrate)
            .message("tap", {}, "keeps where the first end is now", &GestureFeatures::tap)
            .message("fit", {}, "the head is where the taps were, three or more",
                     &GestureFeatures::fit)
            .message(
                "ahead",
                {number("ahead", "s").from(0).to(0.1),
                 number("stop", "m/s^2").from(1).to(10000).by_default(usual.plane.hardest_stop)},
                "strikes on a plane are foretold so long before at most, once a hand that "
                "brakes so hard can no longer stop",
                &GestureFeatures::ahead)
            .message("latency", {number("latency", "s").from(0).to(0.1)},
                     "to make up: strikes go out so long before their time, if they are known",
                     &GestureFeatures::latency)
            .message("softest",
                     {number("plane", "m/s").from(0.01).to(5),
                      number("free", "m/s").from(0.05).to(5).by_default(usual.free.least_speed),
                      number("deceleration", "m/s^2")
                          .from(1)
                          .to(1000)
                          .by_default(usual.free.least_deceleration)},
                     "what is slower is no strike", &GestureFeatures::softest)
            .message("window", {number("window", "s").from(0.01).to(1)},
                     "of poses that a feature is fitted to (it is half of that late)",
                     &GestureFeatures::window)
            .message("reset", {}, "forgets poses, plane and taps", &GestureFeatures::reset)
            .message("print", {}, "dropped REPEATS JUMPS, at the right outlet",
                     &GestureFeatures::print)
            .outlet(
                "strike VELOCITY [m/s] (R [m] THETA [rad]), at its time, as modal-drum~ takes it")
            .outlet(
                "plane END SIDE AHEAD [s] vx vy vz, or free END TURN PEAK [s] DECELERATION dx dy "
                "dz x y z")
            .outlet("position, velocity, speed, acceleration, jerk, direction, turning, "
                    "curvature, angular-velocity, and their delay")
            .outlet("damp R [m] THETA [rad] PRESSURE of the hand")
            .outlet("taps N, plane x y z nx ny nz RESIDUAL [m], dropped"));
}
