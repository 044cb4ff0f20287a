#include "core/modal/resonator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace percussionist::modal {

namespace {

using std::numbers::pi;

/// A mode is kept an oscillation however large its loss: s at most this part of w.
constexpr double kGreatestDamping = 0.9;

std::vector<RoundMode> round_modes(const Body& body, std::size_t count) {
    if (const auto* membrane = std::get_if<Membrane>(&body)) {
        return membrane_modes(*membrane, count);
    }
    if (const auto* plate = std::get_if<Plate>(&body)) {
        return plate_modes(*plate, count);
    }
    return {};
}

GivenModes chosen(GivenModes given, const Choice& choice) {
    check(given);
    std::stable_sort(given.modes.begin(), given.modes.end(),
                     [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
    const auto skipped = std::min(choice.skip, given.modes.size() - 1);
    given.modes.erase(given.modes.begin(), given.modes.begin() + static_cast<long>(skipped));
    while (given.modes.size() > 1 && sounding_modes(given) > choice.count) {
        given.modes.pop_back();
    }
    return given;
}

ModeBank::Mode oscillator(const GivenMode& mode) {
    const double damped = 2 * pi * mode.frequency;
    const double loss = std::min(loss_of_t60(mode.t60), 2 * damped);
    return {.angular_frequency = std::hypot(damped, loss), .loss = loss, .mass = 1.0};
}

}  // namespace

Resonator::Resonator(const Body& body, const Loss& loss, const Choice& choice)
    : body_(body), choice_(choice) {
    check(loss);
    if (choice.count < 1 || choice.count > kMostModes || choice.skip >= kMostModes) {
        throw std::invalid_argument("modes: expected a number from 1 to " +
                                    std::to_string(kMostModes) + ", got " +
                                    std::to_string(choice.count));
    }
    if (const auto* given = std::get_if<GivenModes>(&body)) {
        body_ = chosen(*given, choice);
        oscillators_.resize(sounding_modes(*std::get_if<GivenModes>(&body_)));
    } else {
        round_ = round_modes(body, choice.skip + choice.count);
        oscillators_.resize(round_.size() - std::min(choice.skip, round_.size() - 1));
    }
    set_oscillators(loss);
}

bool Resonator::retune(const Body& body, const Loss& loss) {
    check(loss);
    if (body.index() != body_.index()) {
        return false;
    }
    if (const auto* membrane = std::get_if<Membrane>(&body)) {
        modal::retune(round_, *membrane);
    } else if (const auto* plate = std::get_if<Plate>(&body)) {
        if (plate->poisson != std::get_if<Plate>(&body_)->poisson) {
            return false;
        }
        modal::retune(round_, *plate);
    } else {
        return false;
    }
    body_ = body;
    set_oscillators(loss);
    return true;
}

void Resonator::set_oscillators(const Loss& loss) {
    if (const auto* given = std::get_if<GivenModes>(&body_)) {
        std::size_t k = 0;
        for (const auto& mode : given->modes) {
            oscillators_[k++] = oscillator(mode);
            if (mode.diameters > 0) {
                oscillators_[k++] = oscillator(mode);
            }
        }
        return;
    }
    const double lowest = round_[0].angular_frequency;
    const auto modes = round();
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const double w = modes[k].angular_frequency;
        oscillators_[k] = {.angular_frequency = w,
                           .loss = std::min(loss_at(loss, lowest, w), kGreatestDamping * w),
                           .mass = modes[k].modal_mass};
    }
}

double Resonator::radius() const {
    return std::visit([](const auto& body) { return body.radius; }, body_);
}

std::span<const RoundMode> Resonator::round() const {
    return std::span(round_).last(round_.empty() ? 0 : oscillators_.size());
}

void Resonator::shapes(const Spot& spot, std::span<double> values) const noexcept {
    if (const auto* given = std::get_if<GivenModes>(&body_)) {
        evaluate_weights(*given, spot, values);
    } else {
        evaluate_shapes(round(), spot, values);
    }
}

double Resonator::slope(std::size_t k) const noexcept {
    const auto* membrane = std::get_if<Membrane>(&body_);
    if (!membrane) {
        return 0.0;
    }
    const RoundMode& mode = round()[k];
    return mode.root * mode.root * mode.mass_fraction * pi;  // k^2 R^2 times the mean of phi^2 pi
}

Choice band(const Body& body, double low, double high) {
    std::vector<double> hertz;
    if (const auto* given = std::get_if<GivenModes>(&body)) {
        for (const auto& mode : given->modes) {
            hertz.insert(hertz.end(), mode.diameters > 0 ? 2 : 1, mode.frequency);
        }
        std::sort(hertz.begin(), hertz.end());
    } else {
        for (const auto& mode : round_modes(body, kMostModes)) {
            hertz.push_back(mode.angular_frequency / (2 * pi));
        }
    }
    const auto below = [&](double limit) {
        return static_cast<std::size_t>(
            std::count_if(hertz.begin(), hertz.end(), [&](double f) { return f < limit; }));
    };
    const Choice choice{.count = std::max(below(high), below(low)) - below(low),
                        .skip = below(low)};
    if (choice.count == 0) {
        throw std::invalid_argument("band: expected one that holds a mode, got " +
                                    std::to_string(low) + " to " + std::to_string(high) + " Hz");
    }
    return choice;
}

}  // namespace percussionist::modal
