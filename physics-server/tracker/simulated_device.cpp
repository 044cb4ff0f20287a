#include "tracker/simulated_device.hpp"

#include <sstream>
#include <stdexcept>

namespace percussionist::tracker {

namespace {

bool within(const std::optional<Span>& span, double now) {
    return span && now >= span->at && now < span->at + span->duration;
}

}  // namespace

SimulatedDevice::SimulatedDevice(const SimulatedDeviceSettings& settings, Motion motion,
                                 std::function<void(const std::string&)> tell)
    : settings_(settings),
      motion_(std::move(motion)),
      tell_(std::move(tell)),
      faults_(settings.faults) {
    settings_.unit.damage = [this](motion::Bytes& record) { faults_.damage(record); };
    restart_unit(settings_.unit.baud);
    plug();
}

void SimulatedDevice::restart_unit(int baud) {
    settings_.unit.baud = baud;
    unit_ = std::make_unique<FastrakUnit>(settings_.unit, motion_);
}

void SimulatedDevice::plug() {
    port_ = std::make_unique<PseudoTerminal>(settings_.link);
    tell_(settings_.link.empty() ? port_->name() : settings_.link);
}

bool SimulatedDevice::rates_agree() const {
    return !settings_.strict_baud || port_->baud() == unit_->baud();
}

void SimulatedDevice::run(double now) {
    const bool unplugged = within(settings_.unplug, now);
    if (unplugged) {
        port_.reset();
    } else if (!port_) {
        restart_unit(settings_.unit.baud);  // it has lost its power too
        plug();
    }
    motion::Bytes in, out;
    if (port_) {
        port_->read(in);
    }
    const bool agree = port_ && rates_agree();
    if (agree) {
        unit_->receive(in, now);
    }
    unit_->advance(now, out);
    if (!port_ || within(settings_.silence, now)) {
        return;
    }
    if (!agree) {
        for (std::uint8_t& byte : out) {
            byte = static_cast<std::uint8_t>(noise_());
        }
    }
    port_->write(out);
}

void SimulatedDevice::order(const std::string& line, double now) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) {
        return;
    }
    char letter = 0;
    double value = 0.0;
    const bool good = word == "error" ? static_cast<bool>(words >> letter)
                                      : words >> value && value >= 0.0 && value <= 1e6;
    if (good && (word == "garbage" || word == "cut") && value <= 100) {
        (word == "cut" ? settings_.faults.cut : settings_.faults.garbage) = value / 100;
        faults_.set(settings_.faults.garbage, settings_.faults.cut);
    } else if (good && word == "silence") {
        settings_.silence = Span{now, value};
    } else if (good && word == "unplug") {
        settings_.unplug = Span{now, value};
    } else if (good && word == "baud" && value >= 2400) {
        settings_.strict_baud = true;
        restart_unit(static_cast<int>(value));
    } else if (good && word == "error") {
        unit_->set_error(letter);
    } else {
        throw std::runtime_error(
            line +
            ": expected garbage or cut PERCENT, silence or unplug SECONDS, baud RATE, error "
            "LETTER, or quit");
    }
}

}  // namespace percussionist::tracker
