// One step of a struck head: foresee, find all forces, move.
#include <algorithm>
#include <cmath>

#include "core/modal/struck_head.hpp"

namespace percussionist::modal {

namespace {

/// Coordinate descent on a convex function: it always converges; this many sweeps are never needed.
constexpr int kMostSweeps = 50;

/// How hard a spring holds within a step.
double hold_of(const Spring& spring, double period) {
    return 0.5 * spring.stiffness + spring.resistance / period;
}

}  // namespace

void StruckHead::step(std::span<Striker> strikers, double force) noexcept {
    reserve_ = std::min(reserve_ + 1, kFullReserve);
    direct_.fill(0.0);
    step_at(0, strikers.first(std::min(strikers.size(), kMaxStrikers)), force);
}

void StruckHead::step_at(std::size_t at, std::span<Striker> strikers, double force) noexcept {
    Pace& pace = paces_[at];
    foresee(pace, strikers.size());
    const bool forced = force != 0.0 && ports_[kForce].used;
    if (forced) {
        push_at(pace, kForce, force);
    }
    for (const std::size_t output : pace.sight.watched()) {
        if (output < kPorts) {
            ports_[output].free = pace.sight.coming(output);
        }
    }
    if (forced && stretches_) {
        ports_[kTension].free += force * compliance(pace, kTension, kForce);
    }
    list_springs(pace);
    condense(pace, strikers.size());
    if (find_forces(pace, strikers) && refine(at, strikers, force)) {
        return;
    }
    move(pace, strikers);
    pace.sight.pass();
}

/// Which linear contacts act.
void StruckHead::list_springs(const Pace& pace) noexcept {
    if (!pace.springs_stale && !stretches_) {
        return;
    }
    sprung_count_ = 0;
    for (std::size_t p = kHandPorts; p <= kTension; ++p) {
        if (p == kTension ? stretches_ : ports_[p].used) {
            sprung_[sprung_count_++] = p;
        }
    }
}

void StruckHead::factor_springs(Pace& pace, std::size_t strikers) noexcept {
    const std::size_t n = sprung_count_;
    std::array<Springs::Row, Springs::kMost> among{};
    Springs::Row holds{};
    for (std::size_t i = 0; i < n; ++i) {
        holds[i] = hold_of(spring_[sprung_[i]], pace.period);
        for (std::size_t j = 0; j < n; ++j) {
            among[i][j] = compliance(pace, sprung_[i], sprung_[j]);
        }
    }
    pace.springs.factor(n, among, holds);
    for (std::size_t s = 0; s < strikers; ++s) {
        for (std::size_t i = 0; i < n; ++i) {
            pace.taken[s][i] = compliance(pace, s, sprung_[i]);
        }
        pace.springs.solve(pace.taken[s]);
    }
}

/// The head as the strikers find it, hands and tension answering of themselves.
void StruckHead::condense(Pace& pace, std::size_t strikers) noexcept {
    const std::size_t n = sprung_count_;
    if (n > 0 && (pace.springs_stale || stretches_)) {
        factor_springs(pace, strikers);
    }
    pace.springs_stale = false;
    for (std::size_t i = 0; i < n; ++i) {
        const Port& port = ports_[sprung_[i]];
        const Spring& spring = spring_[sprung_[i]];
        still_[i] = port.free - port.displacement +
                    spring.stiffness * spring.elongation / hold_of(spring, pace.period);
    }
    pace.springs.solve(still_);
    for (std::size_t s = 0; s < strikers; ++s) {
        for (std::size_t i = 0; i < n; ++i) {
            ports_[s].free -= compliance(pace, s, sprung_[i]) * still_[i];
        }
        for (std::size_t t = 0; t < strikers; ++t) {
            condensed_[s][t] = compliance(pace, s, t);
            for (std::size_t i = 0; i < n; ++i) {
                condensed_[s][t] -= compliance(pace, s, sprung_[i]) * pace.taken[t][i];
            }
        }
    }
}

/// Answers whether a mallet turns around too quickly for a step of this length.
bool StruckHead::find_forces(const Pace& pace, std::span<Striker> strikers) noexcept {
    const std::size_t n = strikers.size();
    const double period = pace.period;
    const double half_square = 0.5 * period * period;
    bool hasty = false;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double change = 0.0;
        double greatest = 0.0;
        hasty = false;
        for (std::size_t i = 0; i < n; ++i) {
            Striker& striker = strikers[i];
            const Port& port = ports_[i];
            double head = port.free - port.displacement;
            for (std::size_t j = 0; j < n; ++j) {
                head -= j == i ? 0.0 : condensed_[i][j] * strikers[j].force;
            }
            const ContactStep contact{
                .compression = port.displacement - striker.position,
                .free_change =
                    head - period * striker.velocity - half_square * striker.acceleration,
                .compliance = condensed_[i][i] + half_square / striker.mallet.mass,
                .duration = period,
                .rate = port.rate - striker.velocity,
                .stuck = striker.stuck};
            double guess = striker.force;
            if (sweep == 0) {
                guess += 2 * (striker.force - striker.forces_before[0]) -
                         (striker.forces_before[0] - striker.forces_before[1]);
                striker.forces_before = {striker.force, striker.forces_before[0]};
            }
            const double force = contact_force(striker.mallet, contact, std::max(guess, 0.0));
            change = std::max(change, std::abs(force - striker.force));
            greatest = std::max(greatest, std::abs(force));
            striker.force = force;
            hasty = hasty || turns_hastily(striker.mallet, contact, force);
        }
        if (n == 1 || !(change > 1e-14 * greatest)) {
            break;
        }
    }
    return hasty;
}

/// Everything moves as the forces want it.
void StruckHead::move(Pace& pace, std::span<Striker> strikers) noexcept {
    const std::size_t n = strikers.size();
    const double period = pace.period;
    for (std::size_t i = 0; i < n; ++i) {
        Striker& striker = strikers[i];
        const double acceleration = striker.acceleration + striker.force / striker.mallet.mass;
        striker.position += period * (striker.velocity + 0.5 * period * acceleration);
        striker.velocity += period * acceleration;
        if (striker.force != 0.0) {
            push_at(pace, i, -striker.force);
        }
        double displacement = ports_[i].free;
        for (std::size_t j = 0; j < n; ++j) {
            displacement -= condensed_[i][j] * strikers[j].force;
        }
        ports_[i].rate = (displacement - ports_[i].displacement) / period;
        ports_[i].displacement = displacement;
        const double depth = displacement - striker.position;
        striker.stuck = striker.mallet.stickiness > 0.0 &&
                        (depth > 0.0 || (striker.stuck && depth > -kTackReach));
    }
    for (std::size_t i = 0; i < sprung_count_; ++i) {
        Spring& spring = spring_[sprung_[i]];
        spring.force = still_[i];
        for (std::size_t s = 0; s < n; ++s) {
            spring.force -= pace.taken[s][i] * strikers[s].force;
        }
        const double moved =
            (spring.force - spring.stiffness * spring.elongation) / hold_of(spring, period);
        spring.elongation += moved;
        spring.elongation *= sprung_[i] == kTension ? 1.0 : pace.flesh_keeps;
        ports_[sprung_[i]].displacement += moved;
        push_at(pace, sprung_[i], -spring.force);
    }
}

}  // namespace percussionist::modal
