// One sample of a struck head: swing, find all forces, answer them.
#include <algorithm>
#include <cmath>

#include "core/modal/struck_head.hpp"

namespace percussionist::modal {

namespace {

/// Coordinate descent on a convex function: it always converges; this many sweeps are never needed.
constexpr int kMostSweeps = 50;

}  // namespace

void StruckHead::step(std::span<Striker> strikers, double force) noexcept {
    const auto acting = strikers.first(std::min(strikers.size(), kMaxStrikers));
    swing_freely(acting.size(), force);
    list_springs();
    if (sprung_count_ > 0) {
        condense(acting.size());
    } else {
        for (std::size_t i = 0; i < acting.size(); ++i) {
            std::copy_n(compliance_[i].begin(), acting.size(), condensed_[i].begin());
        }
    }
    find_forces(acting);
    answer(acting);
}

/// To where the sample's end would be without the forces it is to find.
void StruckHead::swing_freely(std::size_t strikers, double force) noexcept {
    const std::span pushes(pushes_.data(), push_count_);
    early_.there = false;
    if (stretches_) {
        Port& tension = ports_[kTension];
        const auto swung = bank_.swing_about(pushes, ports_[0].phi, slope_weights_, tension.phi);
        ports_[0].free = swung.displacement;
        tension.displacement = 0.0;
        tension.free = swung.moved;
    } else if (push_count_ == 1 && pushed_[0] == 0 && !pickups_[0].weights.q.empty()) {
        ports_[0].free =
            bank_.touch(pushes[0].force, ports_[0].phi, pickups_[0].weights, early_.value);
        early_.there = true;
    } else {
        ports_[0].free = bank_.swing(pushes, ports_[0].phi);
    }
    push_count_ = 0;
    for (std::size_t p = 1; p < kTension; ++p) {
        if (p < kMaxStrikers ? p < strikers : ports_[p].used) {
            ports_[p].free = bank_.displacement(ports_[p].phi);
        }
    }
    if (force != 0.0 && ports_[kForce].used) {
        push_at(kForce, force);
        for (std::size_t p = 0; p < kTension; ++p) {
            ports_[p].free += compliance_[p][kForce] * force;
        }
        if (stretches_) {
            ports_[kTension].free +=
                force * bank_.compliance(ports_[kTension].phi, ports_[kForce].phi);
        }
    }
}

void StruckHead::push_at(std::size_t port, double force) noexcept {
    pushes_[push_count_] = {force, ports_[port].phi.data()};
    pushed_[push_count_++] = port;
}

void StruckHead::apply_pushes() noexcept {
    early_.there = early_.there && push_count_ == 0;
    bank_.push({pushes_.data(), push_count_});
    push_count_ = 0;
}

/// Which linear contacts act, and whether they are others than before.
void StruckHead::list_springs() noexcept {
    if (!springs_stale_ && !stretches_) {
        return;
    }
    sprung_count_ = 0;
    for (std::size_t p = kHandPorts; p <= kTension; ++p) {
        if (p == kTension ? stretches_ : ports_[p].used) {
            sprung_[sprung_count_++] = p;
        }
    }
}

/// The head as the strikers find it, hands and tension answering of themselves.
void StruckHead::condense(std::size_t strikers) noexcept {
    const std::size_t n = sprung_count_;
    const auto hold = [&](std::size_t i) {
        const Spring& spring = spring_[sprung_[i]];
        return 0.5 * spring.stiffness + spring.resistance / period_;
    };
    if (stretches_) {
        for (std::size_t p = 0; p <= kTension; ++p) {
            const bool acts = p < kMaxStrikers ? p < strikers : ports_[p].used || p == kTension;
            if (acts) {
                compliance_[p][kTension] = compliance_[kTension][p] =
                    bank_.compliance(ports_[p].phi, ports_[kTension].phi);
            }
        }
    }
    if (springs_stale_ || stretches_) {
        std::array<Springs::Row, Springs::kMost> among{};
        Springs::Row holds{};
        for (std::size_t i = 0; i < n; ++i) {
            holds[i] = hold(i);
            for (std::size_t j = 0; j < n; ++j) {
                among[i][j] = compliance_[sprung_[i]][sprung_[j]];
            }
        }
        springs_.factor(n, among, holds);
        for (std::size_t s = 0; s < kMaxStrikers; ++s) {
            for (std::size_t i = 0; i < n; ++i) {
                taken_[s][i] = ports_[s].used ? compliance_[sprung_[i]][s] : 0.0;
            }
            springs_.solve(taken_[s]);
        }
        springs_stale_ = false;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Port& port = ports_[sprung_[i]];
        const Spring& spring = spring_[sprung_[i]];
        still_[i] = port.free - port.displacement + spring.stiffness * spring.elongation / hold(i);
    }
    springs_.solve(still_);
    for (std::size_t s = 0; s < strikers; ++s) {
        for (std::size_t i = 0; i < n; ++i) {
            ports_[s].free -= compliance_[s][sprung_[i]] * still_[i];
        }
        for (std::size_t t = 0; t < strikers; ++t) {
            condensed_[s][t] = compliance_[s][t];
            for (std::size_t i = 0; i < n; ++i) {
                condensed_[s][t] -= compliance_[s][sprung_[i]] * taken_[t][i];
            }
        }
    }
}

void StruckHead::find_forces(std::span<Striker> strikers) noexcept {
    const std::size_t n = strikers.size();
    const double half_square = 0.5 * period_ * period_;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        double change = 0.0;
        double greatest = 0.0;
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
                    head - period_ * striker.velocity - half_square * striker.acceleration,
                .compliance = condensed_[i][i] + half_square / striker.mallet.mass,
                .duration = period_,
                .rate = port.rate - striker.velocity,
                .stuck = striker.stuck};
            const double guess =
                sweep == 0 ? 2 * striker.force - striker.force_before : striker.force;
            if (sweep == 0) {
                striker.force_before = striker.force;
            }
            const double force = contact_force(striker.mallet, contact, std::max(guess, 0.0));
            change = std::max(change, std::abs(force - striker.force));
            greatest = std::max(greatest, std::abs(force));
            striker.force = force;
        }
        if (n == 1 || !(change > 1e-14 * greatest)) {
            break;
        }
    }
}

/// Everything moves as the forces want it.
void StruckHead::answer(std::span<Striker> strikers) noexcept {
    const std::size_t n = strikers.size();
    for (std::size_t i = 0; i < n; ++i) {
        Striker& striker = strikers[i];
        const double acceleration = striker.acceleration + striker.force / striker.mallet.mass;
        striker.position += period_ * (striker.velocity + 0.5 * period_ * acceleration);
        striker.velocity += period_ * acceleration;
        if (striker.force != 0.0) {
            push_at(i, -striker.force);
        }
        double displacement = ports_[i].free;
        for (std::size_t j = 0; j < n; ++j) {
            displacement -= condensed_[i][j] * strikers[j].force;
        }
        ports_[i].rate = (displacement - ports_[i].displacement) * sample_rate_;
        ports_[i].displacement = displacement;
        const double depth = displacement - striker.position;
        striker.stuck = striker.mallet.stickiness > 0.0 &&
                        (depth > 0.0 || (striker.stuck && depth > -kTackReach));
    }
    for (std::size_t i = 0; i < sprung_count_; ++i) {
        Spring& spring = spring_[sprung_[i]];
        spring.force = still_[i];
        for (std::size_t s = 0; s < n; ++s) {
            spring.force -= taken_[s][i] * strikers[s].force;
        }
        const double hold = 0.5 * spring.stiffness + spring.resistance / period_;
        const double moved = (spring.force - spring.stiffness * spring.elongation) / hold;
        spring.elongation += moved;
        ports_[sprung_[i]].displacement += moved;
        push_at(sprung_[i], -spring.force);
    }
}

double StruckHead::reading(std::size_t i) const noexcept {
    const Pickup& pickup = pickups_[i];
    if (pickup.weights.q.empty()) {
        return 0.0;
    }
    double value = i == 0 && early_.there ? early_.value : bank_.reading(pickup.weights);
    for (std::size_t n = 0; n < push_count_; ++n) {
        const std::size_t p = pushed_[n];
        const double response = p == kTension ? bank_.response(pickup.weights, ports_[kTension].phi)
                                              : pickup.response[p];
        value += pushes_[n].force * response;
    }
    return value;
}

}  // namespace percussionist::modal
