// What the simulated FASTRAK does with what it is told.
#include <cstdio>

#include "core/motion/fastrak_replies.hpp"
#include "tracker/fastrak_setting.hpp"
#include "tracker/fastrak_unit.hpp"

namespace percussionist::tracker {

using motion::kFastrakStations;

namespace {

constexpr double kSaving = 3.0;  // how long ^K takes [s]

}  // namespace

void FastrakUnit::power_up() {
    binary_ = centimetres_ = continuous_ = paused_ = compensation_ = false;
    error_ = ' ';
    filters_['x'] = filters_['v'] = {1.0, 1.0, 0.0, 0.0};
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        Station& station = stations_[i];
        station = Station();
        station.on = static_cast<int>(i) < settings_.receivers;
        for (const Setting& setting : kSettings) {
            station.values[setting.letter].assign(setting.count, 0.0);
        }
        station.values['H'] = {1.0, 0.0, 0.0};
        station.values['A'] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    }
}

void FastrakUnit::receive(std::span<const std::uint8_t> bytes, double now) {
    if (now < deaf_until_) {
        return;
    }
    for (const std::uint8_t byte : bytes) {
        const auto result = reader_.receive(byte);
        if (!result) {
            continue;
        }
        if (const auto* const refused = std::get_if<RefusedCommand>(&*result)) {
            refuse(refused->text, refused->reason, now);
        } else {
            obey(std::get<FastrakCommand>(*result), now);
        }
    }
}

void FastrakUnit::obey(const FastrakCommand& command, double now) {
    command.at_once ? act(command.letter, now) : set(command, now);
}

void FastrakUnit::act(char letter, double now) {
    switch (letter) {
        case 'P':
            for (int i = 0; i < kFastrakStations; ++i) {
                Station& station = stations_[static_cast<std::size_t>(i)];
                if (station.on) {
                    measure(station, i + 1, now - motion::kFastrakLatency);
                    send(station, now);
                }
            }
            return;
        case 'C':
        case 'c':
            continuous_ = letter == 'C';
            return;
        case 'F':
        case 'f':
            binary_ = letter == 'f';
            return;
        case 'U':
        case 'u':
            centimetres_ = letter == 'U';
            return;
        case 'D':
        case 'd':
            compensation_ = letter == 'D';
            return;
        case 'S':
            return tell_status(now);
        case 'T':
            error_ = ' ';
            return;
        case '\x13':
        case '\x11':
            paused_ = letter == '\x13';
            return;
        case 'W':
            return power_up();
        case '\x0b':
            deaf_until_ = now + kSaving;
            return;
        case '\x19':
            power_up();
            wire_.clear();
            deaf_until_ = now + settings_.restart;
            return;
        default:
            return;
    }
}

void FastrakUnit::set(const FastrakCommand& command, double now) {
    const char letter = command.letter;
    if (letter == 'x' || letter == 'v') {
        return set_filter(command, now);
    }
    if (letter == 'o') {
        return set_line(command, now);
    }
    if (command.values.empty() || !command.values[0]) {
        return refuse(command.text, Refusal::kMissing, now);
    }
    const double first = *command.values[0];
    if (letter == 'y') {
        if (first != 0 && first != 1 && first != 2) {
            refuse(command.text, Refusal::kOutOfRange, now);
        }
        return;
    }
    const int number = first >= 1 && first <= kFastrakStations ? static_cast<int>(first) : 0;
    if (number == 0 || number != first) {
        return refuse(command.text, Refusal::kOutOfRange, now);
    }
    set_station(command, stations_[static_cast<std::size_t>(number - 1)], number, now);
}

void FastrakUnit::reply(const std::string& text, double now) {
    const std::string line = text + "\r\n";
    wire_.send({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, now);
}

void FastrakUnit::refuse(const std::string& command, Refusal reason, double now) {
    reply("2 E*ERROR*" + command + "*ERROR* EC" + std::to_string(static_cast<int>(reason)), now);
}

std::string FastrakUnit::states() const {
    std::string text;
    for (const Station& station : stations_) {
        text += station.on ? '1' : '0';
    }
    return text;
}

void FastrakUnit::tell_status(double now) {
    unsigned map = 0;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
        map |= (static_cast<int>(i) < settings_.receivers ? 1U : 0U) << i;
    }
    const unsigned flags = 0x3F0U | (binary_ ? 1U : 0U) | (centimetres_ ? 2U : 0U) |
                           (compensation_ ? 4U : 0U) | (continuous_ ? 8U : 0U);
    char text[64];
    std::snprintf(text, sizeof text, "21S%03X%c   F3%X  %-6s%-32s", flags, error_, map, " 2.00",
                  "3SPACE FASTRAK, simulated");
    reply(text, now);
}

}  // namespace percussionist::tracker
