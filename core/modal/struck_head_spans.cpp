// The spans in which a struck head's modes are moved, and its shorter steps.
#include "core/modal/struck_head.hpp"

namespace percussionist::modal {

/// A new span, when the last is over: how everything moves if no force acts.
void StruckHead::foresee(Pace& pace, std::size_t strikers) noexcept {
    Foresight& sight = pace.sight;
    if (!sight.over() && strikers <= pace.strikers) {
        return;
    }
    land(pace);
    pace.springs_stale = pace.springs_stale || strikers > pace.strikers;
    pace.strikers = strikers;
    std::size_t length = Foresight::kSpan;
    if (stretches_) {
        Port& tension = ports_[kTension];
        tension.free = pace.bank.swing_about(slope_weights_, tension.phi);
        tension.displacement = 0.0;
        sight.forget_input(kTension);
        sight.forget_output(kTension);
        length = 1;
    }
    sight.begin(length);
    for (std::size_t p = 0; p < kTension; ++p) {
        if (p < kMaxStrikers ? p < strikers : ports_[p].used) {
            const auto course = std::span(sight.watch(p)).first(length);
            if (stretches_) {
                course[0] = pace.bank.displacement(ports_[p].phi);
            } else {
                pace.bank.ring(ports_[p].phi, course);
            }
        }
    }
    for (std::size_t i = 0; i < kMaxPickups; ++i) {
        const auto& weights = pickups_[i];
        if (!weights.q.empty()) {
            const auto course = std::span(sight.watch(kPorts + i)).first(length);
            if (stretches_) {
                course[0] = pace.bank.reading(weights);
            } else {
                pace.bank.ring(weights, course);
            }
        }
    }
}

/// What 1 N at a port does at another, or at a pickup.
const Foresight::Course& StruckHead::answer(Pace& pace, std::size_t port,
                                            std::size_t output) noexcept {
    auto& course = pace.sight.answer(port, output);
    if (pace.sight.known(port, output)) {
        return course;
    }
    const auto span = std::span(course).first(stretches_ ? 1 : Foresight::kSpan);
    if (output < kPorts) {
        pace.bank.answer(ports_[port].phi, ports_[output].phi, span);
        pace.sight.answer(output, port) = course;
        pace.sight.known(output, port) = true;
    } else {
        pace.bank.answer(ports_[port].phi, pickups_[output - kPorts], span);
    }
    pace.sight.known(port, output) = true;
    return course;
}

void StruckHead::push_at(Pace& pace, std::size_t port, double force) noexcept {
    for (const std::size_t output : pace.sight.watched()) {
        answer(pace, port, output);
    }
    pace.sight.push(port, force);
}

/// The bank comes to where the span has come.
void StruckHead::land(Pace& pace) noexcept {
    const std::size_t passed = pace.sight.passed();
    if (passed > 0 && !stretches_) {
        pace.bank.advance(passed);
    }
    pace.sight.end([&](std::size_t port, std::span<const double> forces) {
        if (!forces.empty()) {
            pace.bank.give(forces, ports_[port].phi);
        }
    });
}

/// Sixteen shorter steps instead of one, if it may be.
bool StruckHead::refine(std::size_t at, std::span<Striker> strikers, double force) noexcept {
    if (stretches_ || at + 1 == paces_.size() || reserve_ < kRefined) {
        return false;
    }
    reserve_ -= kRefined;
    Pace& pace = paces_[at];
    Pace& finer = paces_[at + 1];
    land(pace);
    for (std::size_t k = 0; finer.modes_stale && k < resonator_.size(); ++k) {
        finer.bank.set(k, pace.bank.mode(k));
    }
    finer.modes_stale = false;
    finer.bank.take_motion(pace.bank);
    std::array<double, kMaxStrikers> forces{};
    for (std::size_t n = 0; n < Foresight::kSpan; ++n) {
        step_at(at + 1, strikers, force);
        for (std::size_t i = 0; i < strikers.size(); ++i) {
            forces[i] += strikers[i].force / static_cast<double>(Foresight::kSpan);
        }
    }
    land(finer);
    pace.bank.take_motion(finer.bank);
    for (std::size_t i = 0; i < strikers.size(); ++i) {
        strikers[i].force = forces[i];
    }
    if (at == 0) {
        read_directly(strikers, force);
    }
    return true;
}

/// What forces do to accelerations at once, which the bank does not keep.
void StruckHead::read_directly(std::span<const Striker> strikers, double force) noexcept {
    const auto add = [this](std::size_t port, double push) {
        for (std::size_t i = 0; i < kMaxPickups; ++i) {
            direct_[i] += push * ModeBank::direct(pickups_[i], ports_[port].phi);
        }
    };
    for (std::size_t i = 0; i < strikers.size(); ++i) {
        add(i, -strikers[i].force);
    }
    for (std::size_t i = 0; i < sprung_count_; ++i) {
        add(sprung_[i], -spring_[sprung_[i]].force);
    }
    if (force != 0.0 && ports_[kForce].used) {
        add(kForce, force);
    }
}

double StruckHead::reading(std::size_t i) const noexcept {
    const auto& weights = pickups_[i];
    if (weights.q.empty()) {
        return 0.0;
    }
    const Pace& pace = paces_.front();
    return pace.sight.passed() > 0 ? pace.sight.last(kPorts + i)
                                   : pace.bank.reading(weights) + direct_[i];
}

}  // namespace percussionist::modal
